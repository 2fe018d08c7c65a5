// What an animation is, and what of it needs no libwebp; its file: animation_webp_test.cpp.
#include "common/plot/animation.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "common/app/error.hpp"
#include "common/plot/draw_animation.hpp"
#include "common/plot/save.hpp"
#include "common/plot/webp_file.hpp"
#include "common/plot/xmp.hpp"

#include "tests/common/app/child.hpp"

using namespace plot;

namespace {

Figure line_to(double end) {
    Figure figure{"unused"};
    figure.panel().curve({0, 1}, {0, end}, {.label = "a, b"});
    return figure;
}

std::string first_fault(const Animation& animation) {
    const auto found = faults(animation);
    return found.empty() ? "" : found.front();
}

}  // namespace

TEST_CASE("the CSV of an animation holds every frame") {
    Animation animation{"lines"};
    for (const double end : {1.0, 2.0, 3.0}) animation.add(line_to(end));
    // Fails if a frame is left out, counted from 0, or loses a column.
    CHECK(data_csv(animation) ==
          "frame,panel,kind,label,x,y,value,error\n"
          "1,a,curve,\"a, b\",0,0,,\n1,a,curve,\"a, b\",1,1,,\n"
          "2,a,curve,\"a, b\",0,0,,\n2,a,curve,\"a, b\",1,2,,\n"
          "3,a,curve,\"a, b\",0,0,,\n3,a,curve,\"a, b\",1,3,,\n");
}

TEST_CASE("a frame without a title has the animation's") {
    Animation animation{"lines", "shared"};
    animation.add(line_to(1)).add(line_to(2));
    animation.frames[1].figure.title = "own";
    CHECK(animation.shown(0).title == "shared");
    CHECK(animation.shown(1).title == "own");
    CHECK(animation.shown(1).name == "lines");
}

TEST_CASE("an animation has 1 to 60 frames of 0.02 to 10 seconds, without faults") {
    Animation animation{"lines"};
    CHECK(first_fault(animation) == "an animation has 1 to 60 frames, not 0");
    for (int k = 0; k < 60; ++k) animation.add(line_to(1), k % 2 == 0 ? 0.02 : 10);
    CHECK(first_fault(animation).empty());
    for (const double seconds : {0.019, 10.01, std::nan("")}) {
        animation.frames[7].seconds = seconds;
        CHECK_THAT(first_fault(animation), Catch::StartsWith("frame 8 is shown for ") &&
                                               Catch::EndsWith(" s, which must be in 0.02..10 s"));
    }
    animation.frames[7] = {line_to(std::nan(""))};
    CHECK_THAT(first_fault(animation), Catch::StartsWith("frame 8: curve \"a, b\": y[1] = nan"));
    animation.name = "No name";
    CHECK_THAT(first_fault(animation), Catch::Contains("name \"No name\" must consist of"));
}

TEST_CASE("61 frames are refused, and nothing is written") {
    const child::Folder folder;
    Animation animation{"lines"};
    for (int k = 0; k < 61; ++k) animation.add(line_to(1));
    Studio studio;
    CHECK_THROWS_AS(studio.save(animation, folder.path(), {}), std::invalid_argument);
    CHECK_THROWS_WITH(studio.save(animation, folder.path(), {}),
                      "animation lines: an animation has 1 to 60 frames, not 61");
    CHECK(folder.names().empty());
}

TEST_CASE("without libwebp an animation is an error that names the package") {
    if (!webp_version().empty()) return;  // then animation_webp_test.cpp is compiled
    const child::Folder folder;
    Animation animation{"lines"};
    animation.add(line_to(1));
    Studio studio;
    CHECK_THROWS_AS(studio.save(animation, folder.path(), {}), app::IoError);
    CHECK_THROWS_WITH(studio.save(animation, folder.path(), {}),
                      Catch::Contains("apt-get install libwebp-dev"));
    CHECK(folder.names().empty());
}

TEST_CASE("a halved picture has the averages of 2x2 pixels") {
    const Image image{5, 3, {0,   1,   2,   10,  11,  12,  255, 254, 253, 255, 255, 255, 9, 9, 9,  //
                             20,  21,  22,  30,  31,  33,  255, 255, 255, 255, 255, 255, 9, 9, 9,  //
                             100, 100, 100, 100, 100, 100, 100, 100, 100, 100, 100, 100, 9, 9, 9}};
    const Image half = halved(image);
    CHECK(half.width == 2);
    CHECK(half.height == 1);
    // Fails if channels are mixed, sums cut to a byte or not rounded, or the odd row and column counted.
    CHECK(half.rgb == std::vector<std::uint8_t>{15, 16, 17, 255, 255, 255});
}

TEST_CASE("an XMP packet is XML whatever its texts hold") {
    const std::string packet = xmp_packet("Δt < 1 & \x01", "sph", "a\nb>c");
    CHECK_THAT(packet, Catch::Contains(">Δt &lt; 1 &amp; \uFFFD</rdf:li></rdf:Alt></dc:title>"));
    CHECK_THAT(packet, Catch::Contains(">a\nb&gt;c</rdf:li></rdf:Alt></dc:description>"));
    CHECK_THAT(packet, Catch::Contains("<xmp:CreatorTool>sph</xmp:CreatorTool>"));
}
