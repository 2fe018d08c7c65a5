#include "chapters/04_artificial_viscosity/scenes/one_at_a_time.hpp"

#include <fmt/format.h>

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
Method<d> reduced(const Method<d>& recommended, const Parts& parts) {
    Method<d> method = on_kernel(recommended, parts.wide);
    method.parameters.set("slopes", parts.slopes ? 1 : 0);
    method.parameters.set("K", parts.K);
    if (!parts.conducts) method.parameters.set("cap", 0);
    return method;
}

std::string name_of(const std::string& viscosity, const Parts& parts) {
    return viscosity + (parts.wide ? " wide" : " narrow") + (parts.conducts ? " conducting" : "");
}

Combination switched(bool wide) {
    const Parts parts{.wide = wide};
    return {name_of("morris-monaghan", parts),
            "Morris–Monaghan",
            "morris-monaghan",
            parts,
            on_kernel(tube_methods()["morris-monaghan"], wide),
            std::nullopt};
}

}  // namespace

Combination combination(const Parts& parts) {
    constexpr double usual = 0.5;
    const std::string K = fmt::format("{:g}", parts.K);
    const std::string look = parts.slopes ? "reconstructed" : parts.K == usual ? "signal" : "narrow";
    const std::string viscosity = parts.slopes ? "reconstructed" : "signal, K = " + K;
    const auto line = reduced(tube_methods().recommended(), parts);
    const auto plane = reduced(plane_methods().recommended(), parts);
    return {name_of(parts.slopes ? "slopes" : "signal " + K, parts), viscosity, look, parts, line,
            parts.K == usual ? std::optional{plane} : std::nullopt};
}

std::vector<Combination> combinations() {
    std::vector<Combination> all;
    const auto add = [&](Parts parts) {
        for (const bool conducts : {false, true}) {
            parts.conducts = conducts;
            all.push_back(combination(parts));
        }
    };
    for (const bool wide : {true, false}) {
        for (const bool slopes : {false, true}) add({.slopes = slopes, .wide = wide});
        if (!wide) add({.K = 0.85, .wide = wide});
        all.push_back(switched(wide));
    }
    return all;
}

}  // namespace sph::shocks
