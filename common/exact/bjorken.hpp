#pragma once

namespace exact {

/// Bjorken's flow: every element of fluid keeps its velocity v_z = z/t since all were at z = 0 at t = 0.
/// Where p = c0^2 eps and tau = sqrt(t^2 - z^2),
///     s/s0 = tau0/tau,   T/T0 = (tau0/tau)^(c0^2),   eps/eps0 = (tau0/tau)^(1 + c0^2).
/// Source: Bjorken, Phys. Rev. D 27 (1983) 140; Chen (2017), eqs 349-352.
struct BjorkenFlow {
    double tau0 = 1;      ///< > 0, finite [T]
    double c2 = 1.0 / 3;  ///< speed of sound squared, [0, 1]

    struct State {
        double temperature, eps, entropy;  ///< in units of those at tau0
    };
    /// At tau > 0. Throws std::domain_error, which names the value, outside these ranges.
    State at(double tau) const;
};

}  // namespace exact
