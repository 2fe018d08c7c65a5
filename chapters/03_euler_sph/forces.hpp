#pragma once
#include "chapters/03_euler_sph/density.hpp"

/// Forms of the pressure force, which all approximate -grad P/rho and differ in what they conserve; and
/// forces on particles one by one.
namespace sph {

/// dv_i/dt = - 1/rho_i sum_j m_j P_j/rho_j grad_i W_ij   (Monaghan 2005, 3.5): the first thing one writes
/// down, with forces of i on j and of j on i that are not opposite (3.6).
struct NonConservingForce {
    using Reads = List<Density>;
    using ReadsJ = List<Mass, Pressure>;
    using Adds = List<Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.dv_dt -= (j.m * j.p / (i.rho * j.rho) * F_i(pair)) * pair.x_ij;
    }
};

// [pressure]
/// dv_i/dt = - sum_j m_j/(rho_i rho_j) (P_i Phi_j/Phi_i grad_i W_ij(h_i) + P_j Phi_i/Phi_j grad_i W_ij(h_j))
/// (review, 5.35). Phi = rho: 3.8. Phi = 1: 5.32, (P_i + P_j)/(rho_i rho_j). Phi = sqrt(P): 5.36. Conserves
/// momentum; and energy if the density is that of Continuity<Phi> (for Phi = rho: or summed) and h constant.
template <class Phi = PhiIsDensity>
struct PressureForce {
    using Reads = List<Density, Pressure>;
    using ReadsJ = List<Mass>;
    using Adds = List<Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const auto ratio = Phi::of(j) / Phi::of(i);
        sum.dv_dt -=
            (j.m / (i.rho * j.rho) * (i.p * ratio * F_i(pair) + j.p / ratio * F_j(pair))) * pair.x_ij;
    }
};
// [end]

// [grad-h]
/// dv_i/dt = - sum_j m_j (P_i/(Omega_i rho_i^2) grad_i W_ij(h_i) + P_j/(Omega_j rho_j^2) grad_i W_ij(h_j))
/// (review, 5.8): what follows from the Lagrangian when h depends on rho. Conserves momentum and energy.
struct GradHForce {
    using Reads = List<Density, Pressure, GradH>;
    using ReadsJ = List<Mass>;
    using Adds = List<Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const double from_i = i.p / (i.Omega * i.rho * i.rho);
        const Tile from_j = j.p / (j.Omega * j.rho * j.rho);
        sum.dv_dt -= (j.m * (from_i * F_i(pair) + from_j * F_j(pair))) * pair.x_ij;
    }
};
// [end]

// What acts on particles one by one. Only scenes that list these have them.

/// dv_i/dt = - Omega^2 x_i: the attraction of all particles, in proportion to their distance, seen from their
/// common centre   (Monaghan 2005, 6.14-6.16)
struct LinearForce {
    double Omega;
    using ReadsI = List<Position>;
    using Writes = List<Acceleration>;
    void finish(const auto& i, const auto&, auto& out) const { out.dv_dt -= (Omega * Omega) * i.x; }
    /// Potential energy by mass.
    template <int d>
    double potential(const Vector<d>& x) const {
        return 0.5 * Omega * Omega * dot(x, x);
    }
};

/// dv_i/dt = - nu v_i: friction that lets a star come to rest   (2.45). nu >= 0 [1/T]
struct Damping {
    double nu;
    using ReadsI = List<Velocity>;
    using Writes = List<Acceleration>;
    void finish(const auto& i, const auto&, auto& out) const { out.dv_dt -= nu * i.v; }
};

}  // namespace sph
