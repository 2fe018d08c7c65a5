#pragma once
#include "chapters/03_euler_sph/density.hpp"

/// Energy that pressure moves: thermal (du = P/rho^2 d rho, 3.12) and thermokinetic (3.16).
namespace sph {

/// du_i/dt = P_i/rho_i^2 d rho_i/dt with the density equation of Phi   (Monaghan 2005, 3.14 for Phi = rho,
/// 3.15 for Phi = 1)
template <class Phi = PhiIsDensity>
struct CompressionHeating {
    using Reads = Union<List<Velocity, Density>, typename Phi::Reads>;
    using ReadsI = List<Pressure>;
    using ReadsJ = List<Mass>;
    using Adds = List<Heating>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const Tile weight = i.p / (i.rho * Phi::of(i)) * (j.m * Phi::of(j) / j.rho);
        sum.du_dt += weight * dot(i.v - j.v, pair.x_ij) * F_i(pair);
    }
};

/// du_i/dt = P_i/(Omega_i rho_i^2) sum_j m_j v_ij . grad_i W_ij(h_i)   (5.13)
struct GradHHeating {
    using Reads = List<Velocity>;
    using ReadsI = List<Density, Pressure, GradH>;
    using ReadsJ = List<Mass>;
    using Adds = List<Heating>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const double weight = i.p / (i.Omega * i.rho * i.rho);
        sum.du_dt += weight * j.m * dot(i.v - j.v, pair.x_ij) * F_i(pair);
    }
};

/// du_i/dt = 1/2 sum_j m_j (P_i/rho_i^2 + P_j/rho_j^2) v_ij . grad_i W_ij   (Chen 2017, 158, 162, 172): half
/// of a pair's work to each. The total is that of (3.14); who is heated is not: du is no longer P/rho^2 d
/// rho, and the entropy of a particle moves without any dissipation.
struct SharedHeating {
    using Reads = List<Velocity, Density, Pressure>;
    using ReadsJ = List<Mass>;
    using Adds = List<Heating>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const Tile work = i.p / (i.rho * i.rho) * F_i(pair) + j.p / (j.rho * j.rho) * F_j(pair);
        sum.du_dt += 0.5 * j.m * work * dot(i.v - j.v, pair.x_ij);
    }
};

/// e = v^2/2 + u   (3.16)
struct ThermokineticEnergy {
    static constexpr std::string_view name = "thermokinetic energy";
    template <class T, int>
    struct In {
        T e{};
    };
};
struct ThermokineticRate {
    static constexpr std::string_view name = "rate of thermokinetic energy";
    template <class T, int>
    struct In {
        T de_dt{};
    };
};
/// de_i/dt = - sum_j m_j (P_i v_j/rho_i^2 + P_j v_i/rho_j^2) . grad_i W_ij   (3.18): antisymmetric, so that
/// the total stands still whatever the time step.
struct Work {
    using Reads = List<Velocity, Density, Pressure>;
    using ReadsJ = List<Mass>;
    using Adds = List<ThermokineticRate>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const double from_i = i.p / (i.rho * i.rho);
        const Tile from_j = j.p / (j.rho * j.rho);
        sum.de_dt -=
            j.m * (from_i * dot(j.v, pair.x_ij) * F_i(pair) + from_j * dot(i.v, pair.x_ij) * F_j(pair));
    }
};

}  // namespace sph
