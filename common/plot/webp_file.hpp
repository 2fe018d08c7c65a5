#pragma once
#include <memory>
#include <string>

#include "common/plot/canvas.hpp"

namespace plot {

/// Writes an animated WebP that repeats for ever: lossy, of quality 70, and of a frame only the box that
/// differs from the one before. The same bytes each time, without a date.
class WebpWriter {
  public:
    /// `name` is for messages. Throws app::IoError naming the Debian package if this program was built
    /// without libwebp.
    explicit WebpWriter(const std::string& name);
    ~WebpWriter();
    WebpWriter(const WebpWriter&) = delete;
    WebpWriter& operator=(const WebpWriter&) = delete;

    /// The next frame, shown for so many ms. Throws std::invalid_argument if its size is not the first one's,
    /// std::runtime_error if libwebp refuses it (more than 16383 pixels each way).
    void add(const Image& image, int milliseconds);
    /// The file's bytes, with the XMP packet. To be called once, after the last frame. Throws
    /// std::runtime_error if libwebp has no memory, or if there is no frame.
    std::string finish(const std::string& xmp);

  private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

/// "libwebp 1.2.4"; empty if this program was built without.
std::string webp_version();

}  // namespace plot
