// One method, one colour and marker, in the whole book.
#include "common/plot/method_looks.hpp"

#include <catch2/catch.hpp>
#include <map>
#include <stdexcept>
#include <tuple>

#include "common/plot/looks.hpp"

TEST_CASE("no two methods look alike, but for those that chapters recommend") {
    // Fails if a colour and a marker are given twice, or a name is.
    std::map<std::tuple<double, double, double, plot::Marker>, int> seen;
    std::map<std::string, int> names;
    for (const std::string& method : plot::methods_with_looks()) {
        const plot::Style look = plot::look_of(method);
        REQUIRE(look.colour);
        ++seen[{look.colour->red, look.colour->green, look.colour->blue, look.marker}];
        CHECK(++names[method] == 1);
        CHECK(look.marker != plot::Marker::none);
    }
    const plot::Colour blue = plot::cycle(0);
    for (const auto& [look, count] : seen) {
        const bool recommended = look == std::tuple{blue.red, blue.green, blue.blue, plot::Marker::circle};
        CHECK(count == (recommended ? 8 : 1));  // one for each of the chapters 2 to 9
    }
    CHECK_THROWS_AS(plot::look_of("nobody"), std::invalid_argument);
}

TEST_CASE("the exact solution is drawn over the methods, and what is not spoken of beneath them") {
    // Fails if the layers are exchanged.
    const int methods = plot::look_of("reconstructed").layer;
    CHECK(plot::exact().layer > methods);
    CHECK(plot::exact().width < plot::look_of("reconstructed").width);
    CHECK(plot::rest().layer < methods);
    CHECK(plot::rest("others").label == "others");
}
