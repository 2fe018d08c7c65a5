// The file of an animation, read back with libwebp's own decoder. Compiled where libwebp is installed.
#include <webp/demux.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <random>

#include "common/app/error.hpp"
#include "common/app/files.hpp"
#include "common/plot/draw_animation.hpp"
#include "common/plot/save.hpp"
#include "common/plot/webp_file.hpp"

#include "tests/common/app/child.hpp"

using namespace plot;

namespace {

struct Shown {
    Image image;
    int milliseconds;
};
struct Film {
    int width = 0, height = 0, loops = -1;
    unsigned count = 0;
    std::vector<Shown> frames{};
    bool has_xmp = false;
};

Film decoded(const std::string& bytes) {
    const WebPData data{reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
    const std::unique_ptr<WebPAnimDecoder, decltype(&WebPAnimDecoderDelete)> decoder{
        WebPAnimDecoderNew(&data, nullptr), WebPAnimDecoderDelete};
    REQUIRE(decoder);
    WebPAnimInfo info;
    REQUIRE(WebPAnimDecoderGetInfo(decoder.get(), &info) == 1);
    Film film{static_cast<int>(info.canvas_width), static_cast<int>(info.canvas_height),
              static_cast<int>(info.loop_count), info.frame_count};
    const WebPDemuxer* demuxer = WebPAnimDecoderGetDemuxer(decoder.get());
    film.has_xmp = (WebPDemuxGetI(demuxer, WEBP_FF_FORMAT_FLAGS) & XMP_FLAG) != 0;
    int time = 0, before = 0;  // when a frame ends
    for (std::uint8_t* rgba = nullptr; WebPAnimDecoderHasMoreFrames(decoder.get()) != 0; before = time) {
        REQUIRE(WebPAnimDecoderGetNext(decoder.get(), &rgba, &time) == 1);
        Image image{film.width, film.height, {}};
        for (int k = 0; k < 4 * film.width * film.height; ++k)
            if (k % 4 < 3) image.rgb.push_back(rgba[k]);
        film.frames.push_back({std::move(image), time - before});
    }
    return film;
}

double mean_difference(const Image& a, const Image& b) {
    REQUIRE(a.rgb.size() == b.rgb.size());
    double sum = 0;
    for (std::size_t k = 0; k < a.rgb.size(); ++k) sum += std::abs(int{a.rgb[k]} - int{b.rgb[k]});
    return sum / static_cast<double>(a.rgb.size());
}

/// A wave of particles with its curve, the way a run is shown.
Figure wave_at(double t) {
    Figure figure{"wave"};
    auto& panel = figure.panel().x_range(0, 1).y_range(-1.3, 1.3).labels("$x$", "$v$");
    Values x(1000), v(1000);
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] = (static_cast<double>(i) + 0.5) / 1000;
        v[i] = std::sin(2 * M_PI * (x[i] - t)) + 0.1 * std::sin(77.7 * static_cast<double>(i));
    }
    panel.points(x, v, {.label = "SPH"});
    panel.curve({0, 1}, {0, 0}, {.label = "zero"});
    return figure;
}

/// A field that changes by less than 6/255 of a colour from one frame to the next.
Figure slow_field(double t) {
    Figure figure{"field"};
    figure.panel_width = 200;
    figure.panel_height = 150;
    Field field{.x = {0, 0.25, 0.5, 0.75, 1}, .y = {0, 1}, .value = {}, .bar = {.range = {{-1, 1}}}};
    for (int row = 0; row < 2; ++row)
        for (const double x : field.x) field.value.push_back(std::sin(3 * x + t));
    figure.panel().field(field);
    return figure;
}

/// Discs without any order: what no codec makes small.
Figure noise(std::mt19937& random) {
    std::uniform_real_distribution<double> uniform{0, 1};
    Discs discs{.x = {}, .y = {}, .value = {}, .diameter = 3};
    for (Values* values : {&discs.x, &discs.y, &discs.value})
        for (int k = 0; k < 20000; ++k) values->push_back(uniform(random));
    Figure figure{"noise"};
    figure.panel().particles(discs);
    return figure;
}

const Metadata made_by{"./tutorial run 01 --only x", "h=1.2", "abc123"};

}  // namespace

TEST_CASE("a WebP shows every frame as it is drawn, as long as it should, for ever") {
    const child::Folder folder;
    Animation animation{"wave", "A wave"};
    animation.add(wave_at(0), 0.1).add(wave_at(0.02), 0.25).add(wave_at(0.02), 1.0 / 30);
    Studio studio;
    studio.save(animation, folder.path() / "new", made_by);
    CHECK(app::read_file(folder.path() / "new" / "wave.csv") == data_csv(animation));
    const Film film = decoded(app::read_file(folder.path() / "new" / "wave.webp"));
    CHECK(film.width == 800);
    CHECK(film.height == 600);
    CHECK(film.loops == 0);  // for ever
    CHECK(film.count == 3);  // fails if a frame that equals the one before is left out
    REQUIRE(film.frames.size() == 3);
    CHECK(film.frames[0].milliseconds == 100);
    CHECK(film.frames[1].milliseconds == 250);
    CHECK(film.frames[2].milliseconds == 33);
    Canvas canvas;
    for (std::size_t k = 0; k < 3; ++k) {
        const double difference = mean_difference(film.frames[k].image, draw_frame(canvas, animation, k));
        INFO(k << ": " << difference);
        // Of 255. Measured: 0.793, 0.789, 0.789; 0.98 without the sharp conversion of colours, 2.0 with
        // quality 10, 2.2 in the second frame if its box begins at odd numbers.
        CHECK(difference < 0.9);
    }
}

TEST_CASE("what changes slowly changes in the WebP too") {
    const child::Folder folder;
    Animation animation{"field"};
    for (int k = 0; k < 24; ++k) animation.add(slow_field(0.015 * k));
    Studio studio;
    studio.save(animation, folder.path(), made_by);
    const Film film = decoded(app::read_file(folder.path() / "field.webp"));
    REQUIRE(film.frames.size() == 24);
    Canvas canvas;
    const double last = mean_difference(film.frames[23].image, draw_frame(canvas, animation, 23));
    CHECK(last < 1.5);  // of 255. Measured: 1.30, as in the first; 13 if differences below 6 are left out
}

TEST_CASE("what changes between frames may lie anywhere") {
    std::vector<Image> images(8, Image{65, 48, std::vector<std::uint8_t>(3 * 65 * 48, 255)});
    WebpWriter writer{"squares"};
    for (std::size_t k = 0; k < images.size(); ++k) {
        for (std::size_t y = 0; y < 5; ++y)  // a dark square that goes down to the left, at odd numbers
            for (std::size_t x = 0; x < 15; ++x)
                images[k].rgb[3 * (65 * (6 * k + y + 1) + 59 - 8 * k) + x] = 50;
        writer.add(images[k], 50);
    }
    const Film film = decoded(writer.finish("x"));
    REQUIRE(film.frames.size() == images.size());
    double largest = 0;
    for (std::size_t k = 0; k < images.size(); ++k)
        largest = std::max(largest, mean_difference(film.frames[k].image, images[k]));
    // Of 255. Measured: 0.238; 1.7 if a box begins at odd numbers, 0.56 if it loses its last row, 2.5 its
    // last column.
    CHECK(largest < 0.3);
}

TEST_CASE("wide figures are halved in a WebP") {
    const child::Folder folder;
    Animation animation{"wide"};
    for (const double end : {1.0, 2.0}) {
        Figure figure{"two", 1, 2};
        for (Panel& panel : figure.panels) panel.curve({0, 1}, {0, end});
        animation.add(figure);
    }
    Studio studio;
    studio.save(animation, folder.path(), made_by);
    const Film film = decoded(app::read_file(folder.path() / "wide.webp"));
    CHECK(film.width == 800);
    CHECK(film.height == 300);
}

TEST_CASE("the bytes of a WebP tell how it was made, and depend on nothing else") {
    const child::Folder folder;
    Animation animation{"wave", "A <wave>"};
    animation.add(wave_at(0)).add(wave_at(0.02));
    {
        Studio studio;
        studio.save(animation, folder.path() / "a", made_by);
    }
    Studio another;
    Animation other{"other"};
    another.save(other.add(wave_at(0.5)), folder.path(), made_by);
    another.save(animation, folder.path() / "b", made_by);
    const std::string bytes = app::read_file(folder.path() / "a" / "wave.webp");
    // Fails with a date in the metadata, or if the canvas kept something of another picture.
    CHECK((app::read_file(folder.path() / "b" / "wave.webp") == bytes));
    CHECK(decoded(bytes).has_xmp);
    CHECK_THAT(bytes,
               Catch::Contains("command: ./tutorial run 01 --only x\nparameters: h=1.2\nrevision: abc123<"));
    CHECK_THAT(bytes, Catch::Contains(">A &lt;wave&gt;<"));
    // Nothing but files of that name: no temporary ones.
    CHECK(folder.names() == std::vector<std::string>{"a", "b", "other.csv", "other.webp"});
}

TEST_CASE("frames of different sizes are refused, and nothing is written") {
    const child::Folder folder;
    Animation animation{"wave"};
    animation.add(wave_at(0)).add(wave_at(0.1));
    animation.frames[1].figure.panel_height = 310;
    Studio studio;
    CHECK_THROWS_AS(studio.save(animation, folder.path(), {}), std::invalid_argument);
    CHECK_THROWS_WITH(studio.save(animation, folder.path(), {}),
                      "animation wave: frame 2 has 800 x 620 pixels, those before 800 x 600");
    CHECK(folder.names().empty());
}

TEST_CASE("a WebP that is too large is refused, and nothing is written") {
    const child::Folder folder;
    Animation animation{"noise"};
    std::mt19937 random{1};
    for (int k = 0; k < 14; ++k)  // measured: 2.06 MB
        animation.add(noise(random));
    Studio studio;
    std::string message;
    try {
        studio.save(animation, folder.path(), {});
    } catch (const TooLarge& error) {
        message = error.what();
    }
    CHECK_THAT(message, Catch::StartsWith("animation noise: its WebP would have "));
    CHECK_THAT(message, Catch::Contains(" MB, and 1.50 MB is the limit; "));
    CHECK(folder.names().empty());
}

TEST_CASE("an animation leaves no half file where it cannot be written") {
    const child::Folder folder;
    app::write_file(folder.path() / "file", "no folder");
    std::filesystem::create_directories(folder.path() / "wave.webp");
    Animation animation{"wave"};
    animation.add(wave_at(0)).add(wave_at(0.1));
    Studio studio;
    CHECK_THROWS_AS(studio.save(animation, folder.path() / "file", {}), app::IoError);
    CHECK(folder.names() == std::vector<std::string>{"file", "wave.webp"});
    CHECK_THROWS_AS(studio.save(animation, folder.path(), {}), app::IoError);
    // The CSV is whole; of the WebP there is nothing, not even a temporary file.
    CHECK(folder.names() == std::vector<std::string>{"file", "wave.csv", "wave.webp"});
    CHECK(app::read_file(folder.path() / "wave.csv") == data_csv(animation));
    CHECK(app::read_file(folder.path() / "file") == "no folder");
}
