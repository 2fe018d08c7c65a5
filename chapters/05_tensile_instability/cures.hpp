#pragma once
#include "chapters/02_consistency/corrected.hpp"
#include "chapters/03_euler_sph/forces.hpp"
#include "chapters/05_tensile_instability/elasticity.hpp"

/// Cures of the tensile instability in a liquid: effects that stand beside PressureForce, or instead of it,
/// and what moves particles with another velocity than theirs. XSPH, and what remembers where particles
/// began, are in elasticity.hpp and total_lagrangian.hpp.
namespace sph {

/// dv_i/dt = - sum_j m_j (R_i + R_j) (W_ij/W(dx))^n grad_i W_ij, R = epsilon max(-P, 0)/rho^2   (Monaghan
/// 2000): the artificial stress of a fluid, a repulsion of near pairs under tension.
/// Antisymmetric: momentum is exact. Its sum over a lattice is a pressure that nobody asked for.
struct ArtificialPressure {
    double epsilon = 0.2;  ///< >= 0; 0.2 for n = 4 (Monaghan 2000), 0.3 for solids (Gray et al. 2001)
    double W_spacing = 1;  ///< W at the spacing of the lattice, > 0   [1/L^d]
    double below = 0;      ///< it acts where the pressure is below this, as far as it is
    // [artificial-pressure]
    using Reads = List<Density, Pressure>;
    using ReadsJ = List<Mass>;
    using Adds = List<Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const double R_i = epsilon * std::max(below - i.p, 0.0) / (i.rho * i.rho);
        const Tile R_j = epsilon * (below - j.p).max(0.0) / (j.rho * j.rho);
        const Tile near = square(square(pair.W / W_spacing));
        sum.dv_dt -= (j.m * (R_i + R_j) * near * pair.F) * pair.x_ij;
    }
    // [end]
};

/// dv_i/dt = 2 w sum_j m_j P_i/(rho_i rho_j) grad_i W_ij: beside PressureForce it takes the share w from
/// P_j + P_i to P_j - P_i. A sum that vanishes with the disorder, so the share costs no accuracy; what it
/// costs is that the forces of a pair are no longer opposite. 0 <= w <= 1
struct ShareOfDifference {
    double w = 1;
    using ReadsI = List<Pressure>;
    using Reads = List<Density>;
    using ReadsJ = List<Mass>;
    using Adds = List<Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.dv_dt += (2 * w * (i.p / i.rho) * (j.m / j.rho) * pair.F) * pair.x_ij;
    }
};

/// K_i, the inverse of the CorrectionMatrix B_i: K grad W has the right first moment, so that gradients of
/// linear functions are exact   (Bonet & Lok 1999).
struct InverseCorrection {
    static constexpr std::string_view name = "inverse of the correction matrix";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> K{};
    };
};
/// dv_i/dt = - sum_j m_j/(rho_i rho_j) (P_i K_j + P_j K_i) grad_i W_ij: exact for linear P where the sum of
/// (K_i + K_j) grad W vanishes, and antisymmetric: corrected gradients that keep momentum. The forces are no
/// longer along x_ij, so angular momentum goes.
struct LinearExactForce {
    using Reads = List<Density, Pressure, InverseCorrection>;
    using ReadsJ = List<Mass>;
    using Adds = List<Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const Tile weight = j.m / (i.rho * j.rho) * pair.F;
        for (std::size_t a = 0; a < pair.x_ij.size(); ++a) {
            for (std::size_t b = 0; b < pair.x_ij.size(); ++b)
                sum.dv_dt[a] -= weight * (i.p * j.K[a][b] + j.p * i.K[a][b]) * pair.x_ij[b];
        }
    }
};

/// dv_i/dt = - grad P_i/rho_i, with the slope of P that MatrixGradient finds from P_j - P_i: exact for linear
/// P, none for a constant one, and no pair's forces are opposite.
struct SlopeForce {
    using ReadsI = List<MatrixGradient<>, Density>;
    using Writes = List<Acceleration>;
    void finish(const auto& i, const auto&, auto& out) const { out.dv_dt -= (1 / i.rho) * i.matrix; }
};

/// The potential of a background pressure, phi_i = 2 P_b/rho_0^2 sum_j m_j W_ij, by mass; half of its sum
/// over particles is an energy.
struct BackgroundPotential {
    static constexpr std::string_view name = "potential of the background pressure";
    template <class T, int>
    struct In {
        T phi{};
    };
};
/// dv_i/dt = sum_j m_j (A_i/rho_i^2 + A_j/rho_j^2) grad_i W_ij, A = rho v (dx/dt - v)^T   (Adami, Hu & Adams
/// 2013): the momentum that particles carry with them where they do not move with v.
struct TransportStress {
    using Reads = List<Velocity, TransportVelocity, Density>;
    using ReadsJ = List<Mass>;
    using Adds = List<Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const Tile across_i = dot(i.v_x - i.v, pair.x_ij), across_j = dot(j.v_x - j.v, pair.x_ij);
        sum.dv_dt += (j.m * pair.F * across_i / i.rho) * i.v + (j.m * pair.F * across_j / j.rho) * j.v;
    }
};

/// g_i = sum_j V_j (1 + R (W_ij/W(dx))^4) grad_i W_ij: 0 in order, and away from where particles are too few.
/// R = 0.2 keeps pairs apart (Lind et al. 2012), R = 0 is the gradient of a constant.
struct DisorderGradient {
    static constexpr std::string_view name = "gradient of the disorder";
    template <class T, int d>
    struct In {
        Vec<T, d> disorder{};
    };
    double R = 0, W_spacing = 1;  ///< >= 0; W at the spacing of the lattice, > 0
    using ReadsJ = List<Volume>;
    using Adds = List<DisorderGradient>;
    void add(const auto&, const auto& j, const auto& pair, auto& sum) const {
        const Tile near = square(square(pair.W / W_spacing));
        sum.disorder += (j.V * (1 + R * near) * pair.F) * pair.x_ij;
    }
};

/// What a pass over other neighbours has summed, and what adds it to the forces of this one.
struct OtherForce {
    static constexpr std::string_view name = "force of another pass";
    template <class T, int d>
    struct In {
        Vec<T, d> other{};
    };
};
struct WithOtherForce {
    using ReadsI = List<OtherForce>;
    using Writes = List<Acceleration>;
    void finish(const auto& i, const auto&, auto& out) const { out.dv_dt += i.other; }
};
/// dv_i/dt = - sum_j m_j (2 P_b/rho_0^2) grad_i W_ij: the force of a pressure P_b that is the same everywhere
/// and at all times, between particles of the density rho_0. A potential of pairs: momentum, angular momentum
/// and energy are exact. With the kernel TwoWidths it has no net stress.
struct BackgroundForce {
    // [background]
    double P_b = 0;    ///< >= 0   [pressure]
    double rho_0 = 1;  ///< > 0   [density]
    using ReadsJ = List<Mass>;
    using Adds = List<Acceleration, BackgroundPotential>;
    void add(const auto&, const auto& j, const auto& pair, auto& sum) const {
        const double strength = 2 * P_b / (rho_0 * rho_0);
        sum.dv_dt -= (strength * j.m * pair.F) * pair.x_ij;
        sum.phi += strength * j.m * pair.W;
    }
    // [end]
};

/// A narrow kernel less a wide one, each divided by its own stress on a lattice: a kernel for ConstantH whose
/// gradient holds the lattice with no stress at all. Short waves see the narrow kernel only, long waves
/// neither. Not positive, and of no use for sums.
template <class Narrow, class Wide>
struct TwoWidths {
    Narrow narrow{};
    Wide wide{};
    double ratio = 2;  ///< smoothing length of the wide kernel over that of the narrow one, > 0
    double stress = 1, wide_stress = 1;  ///< - 1/2 sum_j x . grad W of each on the lattice: 1 in the limit
    double support = std::max(narrow.support, ratio* wide.support);
    // [two-widths]
    Tile W(const Tile& r, double h) const {
        return narrow.W(r, h) / stress - wide.W(r, ratio * h) / wide_stress;
    }
    Tile F(const Tile& r, double h) const {
        return narrow.F(r, h) / stress - wide.F(r, ratio * h) / wide_stress;
    }
    // [end]
    Tile d2W_dr2(const Tile& r, double h) const {
        return narrow.d2W_dr2(r, h) / stress - wide.d2W_dr2(r, ratio * h) / wide_stress;
    }
};

}  // namespace sph
