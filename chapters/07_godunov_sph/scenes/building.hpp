#pragma once
#include "chapters/07_godunov_sph/godunov_gas.hpp"
#include "chapters/07_godunov_sph/scenes/godunov_methods.hpp"

/// Methods out of Godunov schemes: what registers compile, and nobody else.
namespace sph::godunov {

// Energy hangs on the work of pairs, not on h: one Newton step after 1e-4 leaves 1e-8.
inline constexpr double close_h = 1e-4;

/// A method of that scheme; resolution(method) makes where density and h come from.
template <int d, class Scheme, class MakeResolution>
Method<d> solving(const Method<d>& described, const Scheme& scheme, MakeResolution resolution) {
    Method<d> method = described;
    method.parameters = parameters_of(scheme);
    method.build = [scheme, resolution](const Method<d>& chosen,
                                        const Setup<d>& setup) -> std::unique_ptr<Simulation<d>> {
        auto made = resolution(chosen);
        return std::make_unique<GodunovGas<decltype(made), Scheme, Box<d>>>(
            setup.n, std::move(made), setup.state, with_parameters(scheme, chosen.parameters), setup.box,
            setup.courant, setup.threads);
    };
    return method;
}
/// With h consistent with the density that it gives, of a kernel K.
template <class K, class Scheme>
Method<K::dimension> with_own_h(const Method<K::dimension>& described, const Scheme& scheme) {
    return solving(described, scheme, [](const auto& method) {
        return ConsistentH<K>{HRule{method.h_over_dx}, close_h};
    });
}

/// The paper's scheme: its steps know the speed of sound only, and none is taken back.
template <class Scheme>
Scheme as_printed(Scheme scheme = {}) {
    scheme.retries = false;
    return scheme;
}
/// h as the paper has it   (Inutsuka 2002, 81 and 82): C_smooth = 2 on a line, 1 in the plane.
template <class K, class Scheme>
Method<K::dimension> with_smooth_h(const Method<K::dimension>& described, const Scheme& scheme) {
    return solving(described, scheme, [](const auto& method) {
        constexpr double C_smooth = K::dimension == 1 ? 2 : 1;
        return SmoothWidth<K>{method.h_over_dx, C_smooth, close_h};
    });
}

}  // namespace sph::godunov
