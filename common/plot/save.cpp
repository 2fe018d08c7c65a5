#include "common/plot/save.hpp"

#include <stdexcept>

#include "common/app/command_line.hpp"
#include "common/app/files.hpp"
#include "common/plot/canvas.hpp"
#include "common/plot/draw_figure.hpp"
#include "common/plot/png_file.hpp"
#include "common/plot/sizes.hpp"

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

std::string Studio::renderer() const {
    return self_->canvas.renderer();
}

}  // namespace plot
