#pragma once
#include "chapters/02_consistency/moments.hpp"
#include "chapters/03_euler_sph/sides.hpp"

/// Density by summation is chapter 1's SummedDensity. Here: by continuity, in the forms that follow from a
/// function Phi, and what a varying h needs.
namespace sph {

/// The function Phi of Monaghan 2005, (2.12) and (5.33)-(5.35), that decides which density equation and which
/// pressure force belong together.
struct PhiIsDensity {
    using Reads = List<>;
    static const auto& of(const auto& a) { return a.rho; }
};
struct PhiIsOne {
    using Reads = List<>;
    static auto of(const auto&) { return 1.0; }
};
/// The choice of (5.36). Pressures must be positive.
struct PhiIsRootPressure {
    using Reads = List<Pressure>;
    static auto of(const auto& a) {
        using std::sqrt;
        return sqrt(a.p);
    }
};

// [continuity]
/// d rho_i/dt = rho_i/Phi_i sum_j m_j Phi_j/rho_j v_ij . grad_i W_ij   (review, 5.34 with its minus sign).
/// Phi = rho: 2.18. Phi = 1: 2.17, to which the factor rho_i of 2.20 belongs.
template <class Phi>
struct Continuity {
    using Reads = Union<List<Velocity, Density>, typename Phi::Reads>;
    using ReadsJ = List<Mass>;
    using Adds = List<DensityRate>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const Tile weight = i.rho / Phi::of(i) * (j.m * Phi::of(j) / j.rho);
        sum.drho_dt += weight * dot(i.v - j.v, pair.x_ij) * F_i(pair);
    }
};
// [end]

/// d rho_i/dt = - rho_i sum_j m_j/rho_j v_j . grad_i W_ij   (Chen 2017, 166): the divergence as it stands,
/// which does not vanish for a common velocity where W is cut off.
struct PlainContinuity {
    static constexpr std::string_view name = "plain rate of density";
    template <class T, int>
    struct In {
        T plain_drho_dt{};
    };
    using ReadsI = List<Density>;
    using ReadsJ = List<Mass, Velocity, Density>;
    using Adds = List<PlainContinuity>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.plain_drho_dt -= (i.rho * j.m / j.rho) * dot(j.v, pair.x_ij) * F_i(pair);
    }
};

/// rho_i = sum_j m_j W_ij / sum_j (m_j/rho_j) W_ij   (Chen 2017, 165): right at an end, where the sum
/// alone sees half of the particles; needs the densities of before, and is not the density of a Lagrangian.
struct NormalisedDensity {
    static constexpr std::string_view name = "normalised density";
    template <class T, int>
    struct In {
        T normalised{};
    };
    using Uses = List<SummedDensity, ZerothMoment>;
    using Writes = List<NormalisedDensity>;
    void finish(const auto&, const auto& sum, auto& out) const { out.normalised = sum.rho / sum.m0; }
};

/// d rho_i/d h_i = sum_j m_j dW_ij/dh, with dW/dh = -(d W + r^2 F)/h at fixed r.
struct DensitySlope {
    static constexpr std::string_view name = "slope of density with h";
    template <class T, int>
    struct In {
        T drho_dh{};
    };
    using ReadsJ = List<Mass>;
    using Adds = List<DensitySlope>;
    void add(const auto&, const auto& j, const auto& pair, auto& sum) const {
        const auto d = static_cast<double>(pair.x_ij.size());
        sum.drho_dh -= j.m * (d * pair.W + pair.r * pair.r * pair.F) / pair.h;
    }
};

/// Omega_i = 1 - dh_i/d rho_i d rho_i/d h_i   (5.7)
struct GradH {
    static constexpr std::string_view name = "Omega";
    template <class T, int>
    struct In {
        T Omega{};
    };
};

}  // namespace sph
