// ./tutorial doctor: what this build draws with and computes with, one line each.
#include <thread>

#include "common/app/command_line.hpp"
#include "common/app/files.hpp"
#include "common/app/program.hpp"
#include "common/plot/save.hpp"
#include "common/plot/webp_file.hpp"

namespace {

/// The vector instructions that this build may use.
const char* simd() {
#if defined(__AVX512F__)
    return "AVX-512: 8 doubles at a time";
#elif defined(__AVX2__)
    return "AVX2: 4 doubles at a time";
#elif defined(__AVX__)
    return "AVX: 4 doubles at a time";
#else
    return "2 doubles at a time";
#endif
}

}  // namespace

int main(int argc, char** argv) {
    return app::run([&] {
        app::CommandLine line_of_words{"doctor", "What this build draws with and computes with."};
        if (!line_of_words.parse(argc, argv)) return;
        const plot::Studio studio;
        std::string text;
        const auto line = [&](std::string name, const std::string& value) {
            name.resize(18, ' ');
            text += name + " " + value + "\n";
        };
        line("version", app::version());
        line("compiler", __VERSION__);
        line("renderer", studio.renderer());
        const std::string webp = plot::webp_version();
        line("animations", webp.empty() ? "none: built without libwebp-dev" : webp);
        line("SIMD", simd());
        line("threads", std::to_string(std::thread::hardware_concurrency()));
        app::write_stdout(text);
    });
}
