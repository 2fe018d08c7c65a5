#pragma once
#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "chapters/04_artificial_viscosity/dissipative_gas.hpp"
#include "chapters/04_artificial_viscosity/scenes/methods.hpp"

/// Methods out of dissipations: what registers compile, and nobody else.
namespace sph::shocks {

/// A gas with a Scheme (a Dissipation), own h, and any kernel: compiled once for all of these.
template <class Scheme, int d>
std::unique_ptr<Simulation<d>> dissipative_gas(const Method<d>& method, const Setup<d>& setup,
                                               const Scheme& scheme) {
    // Energy hangs on the work of pairs, not on h: one Newton step after 1e-4 leaves 1e-8.
    constexpr double close = 1e-4;
    using Resolution = ConsistentH<AnyKernel<d>>;
    return std::make_unique<DissipativeGas<Resolution, Scheme, Box<d>>>(
        setup.n, Resolution{HRule{method.h_over_dx}, close, AnyKernel<d>{method.kernel}}, setup.state, scheme,
        setup.box, setup.courant, setup.threads);
}

/// A method that dissipates by `scheme`, whose knobs become the method's parameters.
template <int d, class Scheme>
Method<d> dissipating(const Method<d>& described, const Scheme& scheme) {
    Method<d> method = described;
    method.parameters = parameters_of(scheme);
    method.build = [scheme](const Method<d>& chosen, const Setup<d>& setup) {
        return dissipative_gas(chosen, setup, with_parameters(scheme, chosen.parameters));
    };
    return method;
}

}  // namespace sph::shocks
