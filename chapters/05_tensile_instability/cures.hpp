#pragma once
#include "chapters/02_consistency/corrected.hpp"
#include "chapters/03_euler_sph/forces.hpp"

/// Cures of the tensile instability that act on forces: effects that stand beside PressureForce, or instead
/// of it. Those that act on the motion are in orderly_motion.hpp.
namespace sph {

/// dv_i/dt = - sum_j m_j (R_i + R_j) (W_ij/W(dx))^n grad_i W_ij, R = epsilon max(-P, 0)/rho^2   (Monaghan
/// 2000; Monaghan 2005, 11.11-11.13): the artificial stress, a repulsion of near pairs under tension.
/// Antisymmetric: momentum is exact. Its sum over a lattice is a pressure that nobody asked for.
struct ArtificialStress {
    double epsilon = 0.2;   ///< >= 0; 0.2 for n = 4 (Monaghan 2000), 0.3 for solids (Gray et al. 2001)
    double W_spacing = 1;   ///< W at the spacing of the lattice, > 0   [1/L^d]
    using Reads = List<Density, Pressure>;
    using ReadsJ = List<Mass>;
    using Adds = List<Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const double R_i = epsilon * std::max(-i.p, 0.0) / (i.rho * i.rho);
        const Tile R_j = epsilon * (-j.p).max(0.0) / (j.rho * j.rho);
        const Tile near = square(square(pair.W / W_spacing));
        sum.dv_dt -= (j.m * (R_i + R_j) * near * pair.F) * pair.x_ij;
    }
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

/// The potential of a background pressure, phi_i = 2 P_b/rho_0^2 sum_j m_j W_ij, by mass; half of its sum over
/// particles is an energy.
struct BackgroundPotential {
    static constexpr std::string_view name = "potential of the background pressure";
    template <class T, int>
    struct In {
        T phi{};
    };
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
/// and energy are exact. With the smoothing TwoWidths it has no net stress.
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

/// A narrow kernel less a wide one, each divided by its own stress on a lattice, so that a force along its
/// gradient holds the lattice with no stress at all. Short waves see the narrow kernel only, long waves
/// neither.
template <class Narrow, class Wide>
struct TwoWidths {
    // [two-widths]
    double h, wide_h;                   ///< smoothing lengths, > 0
    double stress = 1, wide_stress = 1;  ///< of each kernel on the lattice, lattice_stress(): 1 in the limit
    [[no_unique_address]] Narrow narrow{};
    Wide wide{};
    template <int d>
    Pair<d, double> pair(const auto&, const auto&, const Vec<Tile, d>& x_ij) const {
        const Tile r = dot(x_ij, x_ij).sqrt();
        return {x_ij, r, narrow.W(r, h) / stress - wide.W(r, wide_h) / wide_stress,
                narrow.F(r, h) / stress - wide.F(r, wide_h) / wide_stress, 0.0, h};
    }
    // [end]
    double reach() const { return std::max(narrow.support * h, wide.support * wide_h); }
};

}  // namespace sph
