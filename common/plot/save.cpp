#include "common/plot/save.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "common/app/command_line.hpp"
#include "common/app/files.hpp"
#include "common/app/program.hpp"
#include "common/plot/canvas.hpp"
#include "common/plot/draw_animation.hpp"
#include "common/plot/draw_figure.hpp"
#include "common/plot/png_file.hpp"
#include "common/plot/sizes.hpp"
#include "common/plot/webp_file.hpp"
#include "common/plot/xmp.hpp"

namespace plot {
namespace {

std::string comment(const Metadata& metadata) {
    return "command: " + metadata.command + "\nparameters: " + metadata.parameters +
           "\nrevision: " + metadata.revision;
}

/// app::version() is the program's name and the number.
std::string software() {
    const std::string version = app::version();
    return "SPH, step by step " + version.substr(version.rfind(' ') + 1);
}

std::string title(const Figure& figure) {
    if (!figure.title.empty()) return figure.title;
    const std::string& first = figure.panels.front().title;
    return first.empty() ? figure.name : figure.name + ": " + first;
}

std::string encode_webp(Canvas& canvas, const Animation& animation, const std::string& xmp) {
    WebpWriter writer{animation.name};
    for (std::size_t k = 0; k < animation.frames.size(); ++k) {
        app::check_interrupt();
        constexpr double ms = 1000;
        writer.add(draw_frame(canvas, animation, k),
                   static_cast<int>(std::lround(ms * animation.frames[k].seconds)));
    }
    return writer.finish(xmp);
}

void require_small(const std::string& name, std::size_t bytes) {
    constexpr double mega = 1e6;
    if (bytes > largest_animation)
        throw TooLarge{
            fmt::format("animation {}: its WebP would have {:.2f} MB, and {:.2f} MB is the limit; "
                        "it needs fewer or smaller frames",
                        name, static_cast<double>(bytes) / mega, largest_animation / mega)};
}

}  // namespace

struct Studio::Implementation {
    Canvas canvas;
};

Studio::Studio() : self_{std::make_unique<Implementation>()} {}
Studio::~Studio() = default;

void Studio::save(const Figure& figure, const std::filesystem::path& folder, const Metadata& metadata) {
    if (const auto wrong = faults(figure); !wrong.empty())
        throw std::invalid_argument{"figure " + figure.name + ": " + wrong.front()};
    const Image image = draw(self_->canvas, figure);
    const PngTexts texts{{"Title", title(figure)}, {"Software", software()}, {"Comment", comment(metadata)}};
    constexpr double points_per_inch = 72;
    app::write_file(folder / (figure.name + ".csv"), metadata.csv_head + data_csv(figure));
    app::write_file(folder / (figure.name + ".png"),
                    encode_png(image, texts, pixels_per_point * points_per_inch));
}

void Studio::save(const Animation& animation, const std::filesystem::path& folder, const Metadata& metadata) {
    if (const auto wrong = faults(animation); !wrong.empty())
        throw std::invalid_argument{"animation " + animation.name + ": " + wrong.front()};
    const std::string xmp =
        xmp_packet(animation.title.empty() ? animation.name : animation.title, software(), comment(metadata));
    const std::string bytes = encode_webp(self_->canvas, animation, xmp);
    require_small(animation.name, bytes.size());
    app::write_file(folder / (animation.name + ".csv"), metadata.csv_head + data_csv(animation));
    app::write_file(folder / (animation.name + ".webp"), bytes);
}

std::string Studio::renderer() const {
    return self_->canvas.renderer();
}

}  // namespace plot
