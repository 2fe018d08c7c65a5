// Instead of webp_file.cpp where libwebp is not installed.
#include "common/app/error.hpp"
#include "common/plot/webp_file.hpp"

namespace plot {

struct WebpWriter::Implementation {};

WebpWriter::WebpWriter(const std::string&) {
    throw app::IoError{
        "this program was built without libwebp and writes no animations. On Debian: apt-get install "
        "libwebp-dev, then configure and build again"};
}
WebpWriter::~WebpWriter() = default;

void WebpWriter::add(const Image&, int) {}

std::string WebpWriter::finish(const std::string&) {
    return {};
}

std::string webp_version() {
    return {};
}

}  // namespace plot
