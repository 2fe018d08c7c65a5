#include "chapters/04_artificial_viscosity/scenes/one_at_a_time.hpp"

namespace sph::shocks {
namespace {

template <int d>
Method<d> on_kernel(Method<d> method, bool wide) {
    method.kernel = wide ? "cubic" : d == 1 ? "quadratic" : "wendland-c4";
    method.h_over_dx = wide ? 1.2 : d == 1 ? 1.0 : 1.6;
    return method;
}

/// The recommended method with parts of it switched off: without slopes it is the signal viscosity, with a
/// cap of 0 it conducts nothing.
template <int d>
Method<d> part_of(const Method<d>& recommended, bool slopes, double K, bool wide, bool conducts) {
    Method<d> method = on_kernel(recommended, wide);
    method.parameters.set("slopes", slopes ? 1 : 0);
    method.parameters.set("K", K);
    if (!conducts) method.parameters.set("cap", 0);
    return method;
}

}  // namespace

Combination combination(bool slopes, double K, bool wide, bool conducts) {
    const std::string viscosity = slopes     ? "reconstructed"
                                  : K == 0.5 ? "signal, K = 0.5"
                                             : "signal, K = 0.85";
    const std::string name = std::string{slopes     ? "slopes"
                                         : K == 0.5 ? "signal 0.5"
                                                    : "signal 0.85"} +
                             (wide ? " wide" : " narrow") + (conducts ? " conducting" : "");
    const auto line = part_of(tube_methods().recommended(), slopes, K, wide, conducts);
    const auto plane = part_of(plane_methods().recommended(), slopes, K, wide, conducts);
    return {name, viscosity, wide, conducts, line, K == 0.5 ? std::optional{plane} : std::nullopt};
}

std::vector<Combination> combinations() {
    std::vector<Combination> all;
    for (const bool wide : {true, false}) {
        for (const bool slopes : {false, true}) {
            for (const bool conducts : {false, true}) all.push_back(combination(slopes, 0.5, wide, conducts));
        }
        if (!wide) {
            for (const bool conducts : {false, true}) all.push_back(combination(false, 0.85, wide, conducts));
        }
        all.push_back({std::string{"morris-monaghan"} + (wide ? " wide" : " narrow"), "Morris–Monaghan", wide,
                       false, on_kernel(tube_methods()["morris-monaghan"], wide), std::nullopt});
    }
    return all;
}

}  // namespace sph::shocks
