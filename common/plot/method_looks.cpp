#include "common/plot/method_looks.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "common/plot/looks.hpp"

namespace plot {
namespace {

/// Colours of the cycle, by the names that captions use.
enum class Hue : std::size_t { blue, orange, green, pink, sky, gold, ink, brown, indigo, violet };

struct Look {
    std::string_view method;
    Hue hue;
    Marker marker;
};
/// No two share a colour and a marker, but for those that their chapters recommend: blue circles.
constexpr std::array looks{
    // chapter 2: estimates
    Look{"sph", Hue::orange, Marker::square}, Look{"differences", Hue::green, Marker::triangle_up},
    Look{"by-axes", Hue::sky, Marker::plus}, Look{"cspm", Hue::pink, Marker::diamond},
    Look{"linear", Hue::indigo, Marker::triangle_down}, Look{"fit", Hue::blue, Marker::circle},
    Look{"dsph", Hue::sky, Marker::circle}, Look{"one-sided", Hue::violet, Marker::square},
    // chapter 3: where density and h come from
    Look{"fixed-h", Hue::brown, Marker::square}, Look{"averaged-h", Hue::sky, Marker::triangle_up},
    Look{"without-omega", Hue::violet, Marker::diamond}, Look{"consistent-h", Hue::blue, Marker::circle},
    Look{"super-gaussian", Hue::green, Marker::circle},
    // chapter 4: dissipation
    Look{"none", Hue::brown, Marker::plus}, Look{"none-narrow", Hue::sky, Marker::square},
    Look{"none-cubic", Hue::brown, Marker::triangle_down},
    Look{"von-neumann", Hue::gold, Marker::triangle_down}, Look{"bulk", Hue::gold, Marker::square},
    Look{"monaghan-gingold", Hue::pink, Marker::circle}, Look{"mg-gaussian", Hue::brown, Marker::circle},
    Look{"mg-super-gaussian", Hue::indigo, Marker::circle}, Look{"alpha-beta", Hue::orange, Marker::diamond},
    Look{"beta-alone", Hue::orange, Marker::plus}, Look{"signal", Hue::gold, Marker::triangle_up},
    Look{"signal-cubic", Hue::gold, Marker::cross}, Look{"thermokinetic", Hue::green, Marker::square},
    Look{"thermokinetic-all", Hue::green, Marker::plus},
    Look{"morris-monaghan", Hue::indigo, Marker::diamond}, Look{"price", Hue::pink, Marker::triangle_down},
    Look{"narrow", Hue::violet, Marker::triangle_up}, Look{"reconstructed", Hue::blue, Marker::circle},
    Look{"reconstructed-cubic", Hue::green, Marker::diamond}, Look{"balsara", Hue::gold, Marker::diamond},
    Look{"colagrossi", Hue::pink, Marker::square}, Look{"pairwise", Hue::violet, Marker::circle},
    Look{"stress", Hue::orange, Marker::triangle_up}, Look{"layered", Hue::indigo, Marker::square},
    Look{"layered-arithmetic", Hue::sky, Marker::diamond},
    // chapter 5: elastic solids
    Look{"jaumann", Hue::orange, Marker::cross}, Look{"artificial-stress", Hue::green, Marker::cross},
    Look{"strong-xsph", Hue::violet, Marker::triangle_down}, Look{"corrected-rate", Hue::pink, Marker::plus},
    Look{"total-lagrangian", Hue::blue, Marker::circle},
    Look{"total-lagrangian-wide", Hue::indigo, Marker::plus}, Look{"jaumann-narrow", Hue::gold, Marker::plus},
    // chapter 6: Burgers' equation
    Look{"brookshaw", Hue::brown, Marker::diamond}, Look{"fpm", Hue::violet, Marker::plus},
    Look{"sfpm", Hue::sky, Marker::triangle_down}, Look{"taylor", Hue::indigo, Marker::triangle_up},
    Look{"mls", Hue::indigo, Marker::cross}, Look{"sfpm-4", Hue::blue, Marker::square},
    Look{"xsph", Hue::violet, Marker::cross}, Look{"remesh-fit", Hue::pink, Marker::cross},
    Look{"remesh-m4", Hue::brown, Marker::cross}, Look{"frame-2", Hue::blue, Marker::diamond},
    Look{"frame-4", Hue::blue, Marker::circle},
    // chapter 7: Riemann problems between particles
    Look{"inutsuka", Hue::ink, Marker::triangle_down}, Look{"careful", Hue::ink, Marker::triangle_up},
    Look{"own-width", Hue::ink, Marker::diamond}, Look{"limited", Hue::ink, Marker::square},
    Look{"narrow-faces", Hue::ink, Marker::plus}, Look{"varying-h", Hue::blue, Marker::triangle_up},
    Look{"godunov", Hue::blue, Marker::circle}, Look{"conducting", Hue::blue, Marker::triangle_down},
    // chapter 8: relativistic gas, and the slab
    Look{"chow-monaghan", Hue::orange, Marker::circle}, Look{"fixed-4", Hue::brown, Marker::triangle_up},
    Look{"fixed-10", Hue::sky, Marker::cross}, Look{"fixed-20", Hue::gold, Marker::circle},
    Look{"variable", Hue::orange, Marker::triangle_down}, Look{"graded", Hue::pink, Marker::triangle_up},
    Look{"quadratic-h", Hue::green, Marker::triangle_down}, Look{"narrow-graded", Hue::blue, Marker::circle},
    // chapter 9: where particles of the plane begin
    Look{"rings", Hue::ink, Marker::circle}, Look{"relaxed", Hue::ink, Marker::cross},
    Look{"spiral", Hue::blue, Marker::cross}, Look{"spiral-solved", Hue::blue, Marker::plus},
    Look{"spiral-graded", Hue::blue, Marker::circle}};

}  // namespace

Style look_of(std::string_view method, std::string label) {
    if (method == "grid") return competitor(std::move(label));
    if (method == "grid-lagrangian")
        return {.label = std::move(label), .colour = Colour{0.5, 0.5, 0.5}, .marker = Marker::plus};
    const auto* found =
        std::find_if(looks.begin(), looks.end(), [&](const Look& look) { return look.method == method; });
    if (found == looks.end())
        throw std::invalid_argument{"no look for the method " + std::string{method} +
                                    ": see method_looks.cpp"};
    return {.label = std::move(label),
            .colour = cycle(static_cast<std::size_t>(found->hue)),
            .marker = found->marker};
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
