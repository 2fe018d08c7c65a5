#include "common/plot/canvas.hpp"

#include <unistd.h>
#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "common/app/error.hpp"
#include "common/app/files.hpp"
#include "common/plot/png_file.hpp"
#include "tests/common/plot/picture.hpp"

using picture::black;
using picture::drawn;
using picture::ink_at;
using plot::Canvas;
using plot::Colour;
using plot::Image;
using plot::Point;
using plot::Polyline;

namespace {

/// A little of everything.
void draw_everything(Canvas& canvas) {
    const std::vector<Polyline> lines{{{10, 20}, {150, 90}, {290, 15}}, {{20, 180}, {280, 30}}};
    const std::array<double, 4> dashes{9, 5, 2, 5};
    canvas.rectangle({20, 20, 140, 100}, {0.9, 0.9, 1, 1});
    canvas.rule({20, 100}, {140, 100}, 2, black);
    canvas.stroke(lines, 2.5, {0.8, 0.2, 0.1, 0.7});
    canvas.stroke(lines, 1.2, {0.1, 0.2, 0.6, 1}, dashes);
    const std::array<Point, 3> corners{Point{150, 110}, Point{290, 120}, Point{200, 190}};
    const std::array<Colour, 3> colours{Colour{1, 0, 0}, Colour{0, 1, 0, 0.5}, Colour{0, 0, 1}};
    canvas.triangles(corners, colours);
    canvas.discs(corners, 9.3, colours);
    for (const auto shape : {plot::Marker::circle, plot::Marker::square, plot::Marker::cross})
        canvas.markers(corners, {shape, 12.7, {1, 1, 0, 0.5}, black, 1.5, true});
    canvas.text({30, 150}, "ρ_{0}^{2} = $γ$ − 1", {17, black, plot::Anchor::left, {}, 0});
    canvas.text({60, 60}, "angle", {13, {0, 0.5, 0, 1}, plot::Anchor::centre, plot::Vertical::middle, 33});
}

/// An environment variable with another value as long as this lives.
class Environment {
  public:
    Environment(const char* name, const char* value) : name_{name} { ::setenv(name, value, 1); }
    ~Environment() { ::unsetenv(name_); }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

  private:
    const char* name_;
};

}  // namespace

TEST_CASE("a picture begins white, whatever was drawn before") {
    Canvas canvas;
    const auto all_white = [](const Image& image) {
        return std::all_of(image.rgb.begin(), image.rgb.end(), [](auto value) { return value == 255; });
    };
    CHECK_FALSE(all_white(drawn(canvas, 300, 200, draw_everything)));
    // Fails if begin() does not clear, or leaves the clip or waiting text of the last picture.
    canvas.clip({10, 10, 20, 20});
    canvas.text({10, 20}, "left over", {});
    CHECK(all_white(drawn(canvas, 300, 200, [](Canvas&) {})));
    const Image full = drawn(canvas, 30, 20, [](Canvas& c) { c.rectangle({0, 0, 30, 20}, black); });
    CHECK(picture::ink(full).sum == 600);
}

TEST_CASE("pictures of the smallest and the largest sides") {
    Canvas canvas;
    const Image dot = drawn(canvas, 1, 1, [](Canvas& c) { c.rectangle({0, 0, 1, 1}, {1, 0, 0, 1}); });
    CHECK(dot.rgb == std::vector<std::uint8_t>{255, 0, 0});
    // The far ends are probed: fails if a size is cut off (at 8192, say) or rows are mixed up.
    const Image wide = drawn(canvas, 16384, 3, [](Canvas& c) { c.rectangle({16383, 1, 16384, 2}, black); });
    CHECK(picture::ink(wide).sum == 1);
    CHECK(ink_at(wide, 16383, 1) == 1);
    const Image tall = drawn(canvas, 2, 16384, [](Canvas& c) {
        c.rule({0, 16383.5}, {2, 16383.5}, 1, black);
    });
    CHECK(ink_at(tall, 0, 16383) == 1);
    CHECK(picture::ink(tall).sum == 2);
    CHECK_THROWS_AS(canvas.begin(0, 5), std::invalid_argument);
    CHECK_THROWS_AS(canvas.begin(5, 16385), std::invalid_argument);
}

TEST_CASE("drawing without a picture is an error") {
    Canvas canvas;
    CHECK_THROWS_AS(canvas.rule({0, 0}, {5, 0}, 1, black), std::logic_error);
    CHECK_THROWS_AS(canvas.text({0, 0}, "x", {}), std::logic_error);
    CHECK_THROWS_AS(canvas.clip({0, 0, 1, 1}), std::logic_error);
    CHECK_THROWS_AS(canvas.finish(), std::logic_error);
    CHECK_NOTHROW(canvas.measure("x", 20));
}

TEST_CASE("nothing is drawn outside the clip") {
    Canvas canvas;
    const Image image = drawn(canvas, 300, 200, [](Canvas& c) {
        c.clip({40.2, 30.4, 260, 160});
        draw_everything(c);
        c.unclip();
    });
    // Fails if one kind of drawing forgets the clip: each reaches out of it, text by being drawn late.
    const picture::Ink ink = picture::ink(image, 0);
    CHECK(ink.left == 40);
    CHECK(ink.top == 30);
    CHECK(ink.right == 259);
    CHECK(ink.bottom == 159);
    const Image nothing = drawn(canvas, 300, 200, [](Canvas& c) {
        c.clip({400, 30, 500, 60});
        draw_everything(c);
    });
    CHECK(picture::largest_difference(nothing, drawn(canvas, 300, 200, [](Canvas&) {})) == 0);
}

TEST_CASE("what is drawn later covers what was drawn before, text too") {
    Canvas canvas;
    const Image image = drawn(canvas, 60, 40, [](Canvas& c) {
        c.text({5, 30}, "HHH", {20, black, plot::Anchor::left, plot::Vertical::baseline, 0});
        c.rectangle({0, 0, 60, 40}, {1, 1, 1, 1});
    });
    CHECK(picture::ink(image).sum == 0);  // fails if waiting text is drawn at the end only
}

TEST_CASE("the same calls give the same bytes") {
    Canvas first;
    const Image once = drawn(first, 300, 200, draw_everything);
    CHECK(drawn(first, 300, 200, draw_everything).rgb == once.rgb);
    Canvas second;  // while the first is alive: fails if contexts get into each other's way
    CHECK(drawn(second, 300, 200, draw_everything).rgb == once.rgb);
    CHECK(drawn(first, 300, 200, draw_everything).rgb == once.rgb);
}

TEST_CASE("write a picture for another process", "[.picture]") {
    Canvas canvas;
    const char* path = std::getenv("SPH_TEST_PICTURE");
    REQUIRE(path != nullptr);
    app::write_file(path, plot::encode_png(drawn(canvas, 300, 200, draw_everything), {}, 144));
}

TEST_CASE("the number of threads does not change the picture") {
    // The renderer counts its threads when a process begins to use it, so that other processes draw.
    const auto program = std::filesystem::read_symlink("/proc/self/exe").string();
    const auto folder =
        std::filesystem::temp_directory_path() / ("sph_threads_" + std::to_string(::getpid()));
    std::vector<std::string> pictures;
    for (const char* threads : {"0", "1", "2"}) {
        const auto path = folder / (std::string{threads} + ".png");
        std::filesystem::create_directories(folder);
        const Environment count{"LP_NUM_THREADS", threads}, file{"SPH_TEST_PICTURE", path.c_str()};
        REQUIRE(std::system(("'" + program + "' '[.picture]' >/dev/null").c_str()) == 0);
        pictures.push_back(app::read_file(path));
    }
    std::filesystem::remove_all(folder);
    CHECK(pictures[0].size() > 1000);
    CHECK(pictures[1] == pictures[0]);
    CHECK(pictures[2] == pictures[0]);
}

TEST_CASE("a missing font is named with its package") {
    const Environment font{"SPH_FONT", "/nonexistent/font.ttf"};
    try {
        Canvas canvas;
        FAIL("no error");
    } catch (const app::IoError& error) {
        CHECK_THAT(error.what(), Catch::Contains("/nonexistent/font.ttf"));
        CHECK_THAT(error.what(), Catch::Contains("fonts-dejavu-core"));
    }
}

TEST_CASE("the renderer is named") {
    const std::string name = Canvas{}.renderer();
    CHECK_THAT(name, Catch::StartsWith("OSMesa, ") || Catch::StartsWith("EGL, "));
    CHECK_THAT(name, Catch::Contains(" core, Mesa "));
    CHECK_THAT(name, Catch::Contains("llvmpipe"));
}
