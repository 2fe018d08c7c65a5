#include "common/plot/save.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "common/app/error.hpp"
#include "common/app/files.hpp"
#include "common/plot/colour_map.hpp"
#include "common/plot/draw_figure.hpp"
#include "common/plot/png_file.hpp"
#include "common/plot/sizes.hpp"

using namespace plot;
namespace fs = std::filesystem;

namespace {

/// A folder of its own, removed at the end.
struct Folder {
    fs::path path = fs::temp_directory_path() / ("sph_save_" + std::to_string(::getpid()));
    Folder() { fs::remove_all(path); }
    ~Folder() { fs::remove_all(path); }
};

Figure with_everything() {
    Figure figure{"everything", 2, 2};
    figure.title = "Everything $x^{2}$";
    auto& curves = figure.at(0, 0).titled("curves").labels("$x$", "$y$");
    curves.curve({0, 1, 2}, {0, 1, 0.5}, {.label = "line", .marker = Marker::circle}).error = {0.1, 0.2, 0.1};
    curves.curve({0, 2}, {1, 0}, {.label = "dashed", .dash = Dash::dash_dotted, .marker = Marker::cross});
    curves.band({0, 2}, {0, 0.2}, {0.5, 0.7}, "band");
    curves.note(0.2, 0.5, "note").points_at = {{1, 1}};
    auto& slopes = figure.at(0, 1).log_log();
    slopes.curve({1, 10, 100}, {1, 0.01, 1e-4}).error = {2, 0.005, 1e-5};
    slopes.slope(-2, 1, 100, 0.5, "order 2");
    auto& field = figure.at(1, 0);
    field.field({.name = "f",
                 .x = {0, 1, 2},
                 .y = {0, 1},
                 .value = {0, 1, 2, 3, 4, 5},
                 .contours = {1.5, 2.5},
                 .contour_labels = true,
                 .bar = {.label = "bar", .map = Map::magma}});
    field.vectors({.x = {0.5, 1}, .y = {0.5, 0.5}, .u = {1, 0}, .v = {0.2, 0}});
    figure.at(1, 1).equal_aspect = true;
    figure.at(1, 1).particles({.x = {0, 1}, .y = {0, 1}, .value = {1, 10}, .bar = {.scale = Scale::log}});
    return figure;
}

std::string text_of(const PngTexts& texts, const std::string& key) {
    for (const auto& [keyword, text] : texts)
        if (keyword == key) return text;
    return "(none)";
}

}  // namespace

TEST_CASE("save writes a PNG with its metadata and the CSV, the same bytes each time") {
    const Folder folder;
    const Metadata metadata{"./tutorial run 01", "h=1.2", "abc123"};
    const Figure figure = with_everything();
    REQUIRE(faults(figure).empty());
    Studio studio;
    studio.save(figure, folder.path / "new", metadata);
    const std::string png = app::read_file(folder.path / "new" / "everything.png");
    CHECK(app::read_file(folder.path / "new" / "everything.csv") == data_csv(figure));

    PngTexts texts;
    const Image image = decode_png(png, &texts);
    CHECK(image.width == 1600);
    CHECK(image.height == 1200);
    CHECK(text_of(texts, "Title") == "Everything $x^{2}$");
    CHECK(text_of(texts, "Software").starts_with("SPH, step by step "));
    CHECK(text_of(texts, "Comment") == "command: ./tutorial run 01\nparameters: h=1.2\nrevision: abc123");

    // Fails with a date in the metadata, or if the canvas kept something of the first picture.
    Studio another;
    Figure other{"other"};
    other.panel().curve({0, 1}, {0, 1});
    another.save(other, folder.path, metadata);
    another.save(figure, folder.path, metadata);
    CHECK((app::read_file(folder.path / "everything.png") == png));
    // Nothing but the files of two figures: no temporary ones.
    CHECK(std::distance(fs::directory_iterator{folder.path}, fs::directory_iterator{}) == 5);
}

TEST_CASE("save refuses faulty figures and writes nothing") {
    const Folder folder;
    Figure figure{"faulty"};
    figure.panel().curve({0, 1}, {0, std::nan("")});
    Studio studio;
    CHECK_THROWS_WITH(studio.save(figure, folder.path, {}), Catch::Contains("y[1] = nan is not finite"));
    CHECK_FALSE(fs::exists(folder.path / "faulty.csv"));
}

TEST_CASE("data lie where the axes say") {
    Figure figure{"probe"};
    auto& panel = figure.panel();
    panel.x_range(0, 1).y_range(0, 1);
    panel.particles(
        {.x = {0.25}, .y = {0.75}, .value = {1}, .diameter = 10, .bar = {.range = {{0, 1}}, .shown = false}});
    panel.grid = false;
    panel.curve({0.6, 0.8}, {0.1, 0.1}, {.colour = Colour{1, 0, 0, 1}, .width = 3});
    Canvas canvas;
    const Image image = draw(canvas, figure);
    const Layout layout = lay_out(figure, [&](std::string_view t, double s) { return canvas.measure(t, s); });
    const auto at = [&](double x, double y) {
        const auto& p = layout.panels[0];
        const auto column = static_cast<std::size_t>(p.x(x)), row = static_cast<std::size_t>(p.y(y));
        const std::size_t k = 3 * (row * static_cast<std::size_t>(image.width) + column);
        return std::array<int, 3>{image.rgb[k], image.rgb[k + 1], image.rgb[k + 2]};
    };
    // Fails if y grows downwards, or if the colour bar's range is not used for the disc.
    CHECK(at(0.25, 0.75) == std::array<int, 3>{0xfd, 0xe7, 0x25});
    CHECK(at(0.7, 0.1) == std::array<int, 3>{255, 0, 0});
    CHECK(at(0.25, 0.25) == std::array<int, 3>{255, 255, 255});
    CHECK(at(0.5, 0.1) == std::array<int, 3>{255, 255, 255});
}

TEST_CASE("a field shows its values, contours where they are") {
    Figure figure{"field"};
    Field field{.x = {0, 1}, .y = {0, 2}, .value = {0, 1, 0, 1}, .contours = {0.75}, .bar = {.shown = false}};
    figure.panel().field(field);
    Canvas canvas;
    const Image image = draw(canvas, figure);
    const Layout layout = lay_out(figure, [&](std::string_view t, double s) { return canvas.measure(t, s); });
    const auto& panel = layout.panels[0];
    const auto row = static_cast<std::size_t>(panel.y(0.5));
    const auto green_at = [&](double x) {
        return image
            .rgb[3 * (row * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(panel.x(x))) +
                 1];
    };
    for (const double x :
         {0.1, 0.3, 0.6, 0.9})  // within the steps of the lattice; fails if x and y are exchanged
        CHECK(green_at(x) == Approx(255 * map_colour(Map::viridis, x).green).margin(2));
    CHECK(green_at(0.75) < 0.7 * 255 * map_colour(Map::viridis, 0.75).green);  // the contour line
}
