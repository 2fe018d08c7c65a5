#include "common/plot/method_looks.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace plot {
namespace {

constexpr Colour black{0, 0, 0}, grey{0.5, 0.5, 0.5};

/// Colours of the cycle, by the names that captions use.
enum Hue : std::size_t { blue, orange, green, pink, sky, gold, ink, brown, indigo, violet };

struct Look {
    std::string_view method;
    Hue hue;
    Marker marker;
};
/// No two share a colour and a marker, but for those that their chapters recommend: blue circles.
constexpr std::array looks{
    // chapter 2: estimates
    Look{"sph", orange, Marker::square}, Look{"differences", green, Marker::triangle_up},
    Look{"by-axes", sky, Marker::plus}, Look{"cspm", pink, Marker::diamond},
    Look{"linear", indigo, Marker::triangle_down}, Look{"fit", blue, Marker::circle},
    // chapter 3: where density and h come from
    Look{"fixed-h", brown, Marker::square}, Look{"averaged-h", gold, Marker::triangle_up},
    Look{"without-omega", violet, Marker::diamond}, Look{"consistent-h", blue, Marker::circle},
    Look{"super-gaussian", green, Marker::circle},
    // chapter 4: dissipation
    Look{"none", brown, Marker::plus}, Look{"none-narrow", brown, Marker::cross},
    Look{"none-cubic", brown, Marker::triangle_down}, Look{"von-neumann", gold, Marker::triangle_down},
    Look{"bulk", gold, Marker::square}, Look{"monaghan-gingold", pink, Marker::circle},
    Look{"mg-gaussian", brown, Marker::circle}, Look{"mg-super-gaussian", indigo, Marker::circle},
    Look{"alpha-beta", orange, Marker::diamond}, Look{"signal", sky, Marker::triangle_up},
    Look{"signal-cubic", sky, Marker::cross}, Look{"thermokinetic", green, Marker::square},
    Look{"thermokinetic-all", green, Marker::plus}, Look{"morris-monaghan", indigo, Marker::diamond},
    Look{"price", pink, Marker::triangle_down}, Look{"narrow", violet, Marker::triangle_up},
    Look{"reconstructed", blue, Marker::circle}, Look{"reconstructed-cubic", green, Marker::diamond},
    Look{"balsara", gold, Marker::diamond}, Look{"colagrossi", pink, Marker::square},
    Look{"pairwise", blue, Marker::circle}, Look{"stress", orange, Marker::triangle_up},
    // chapter 8: relativistic gas, and the slab
    Look{"chow-monaghan", orange, Marker::circle}, Look{"fixed-4", brown, Marker::triangle_up},
    Look{"fixed-10", gold, Marker::cross}, Look{"fixed-20", violet, Marker::triangle_down},
    Look{"variable", orange, Marker::triangle_down}, Look{"graded", pink, Marker::triangle_up},
    Look{"quadratic-h", green, Marker::triangle_down}, Look{"narrow-graded", blue, Marker::circle}};

}  // namespace

Style look_of(std::string_view method, std::string label) {
    if (method == "grid") return {.label = std::move(label), .colour = black, .marker = Marker::cross};
    if (method == "grid-lagrangian")
        return {.label = std::move(label), .colour = grey, .marker = Marker::plus};
    const auto* found =
        std::find_if(looks.begin(), looks.end(), [&](const Look& look) { return look.method == method; });
    if (found == looks.end())
        throw std::invalid_argument{"no look for the method " + std::string{method} +
                                    ": see method_looks.cpp"};
    return {.label = std::move(label), .colour = cycle(found->hue), .marker = found->marker};
}

std::vector<std::string> methods_with_looks() {
    std::vector<std::string> names{"grid", "grid-lagrangian"};
    for (const Look& look : looks) names.emplace_back(look.method);
    return names;
}

Style rest(std::string label) {
    return {.label = std::move(label), .colour = Colour{0.72, 0.72, 0.72}, .width = 0.8, .layer = 0};
}

}  // namespace plot
