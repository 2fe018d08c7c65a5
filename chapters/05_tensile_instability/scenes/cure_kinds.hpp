#pragma once
#include <memory>

#include "chapters/01_kernel_interpolation/splines.hpp"
#include "chapters/04_artificial_viscosity/physical_viscosity.hpp"
#include "chapters/05_tensile_instability/cures.hpp"
#include "chapters/05_tensile_instability/scenes/lattice_box.hpp"
#include "chapters/05_tensile_instability/total_lagrangian.hpp"
#include "common/core/renamed.hpp"

/// The cures of the chapter as parts of a CuredLiquid (liquid.hpp). Units: dx = c = m = 1.
namespace sph::tensile {

/// Chapter 4's viscosity, the one that acts on all pairs, with nu = alpha c h/8 (Monaghan 2005, 8.7 in 2D):
/// what takes the heat of disordered particles out. alpha >= 0
struct GentleViscosity {
    double alpha = 0, h = 1;
    using Columns = List<MiddleVelocity, SmoothingLength, StepRate>;
    auto effect() const { return ViscousForce<PairwiseViscosity>{{.nu = alpha * h / 8}}; }
    template <class P>
    void resolved(P& p) const {
        p.v_mid = p.v;
        p.h.assign(p.size(), h);
    }
};

/// Forces between pairs, listed beside a viscosity.
template <class... Force>
struct PairCure {
    GentleViscosity damping;
    Effects<Force...> forces;
    using Columns = GentleViscosity::Columns;
    using Drift = Velocity;
    auto effects() const {
        return std::apply(
            [&](const Force&... one) {
                return Effects{one..., damping.effect()};
            },
            forces.list);
    }
    void resolved(auto& p, const auto&) const { damping.resolved(p); }
};

/// The slope of P_j - P_i, corrected; and forces beside it.
template <class... Force>
struct SlopeCure {
    PairCure<Force...> forces;
    using Columns = Union<GentleViscosity::Columns, List<Volume, Quantity, MatrixGradient<>>>;
    using Drift = Velocity;
    auto effects() const {
        return std::apply(
            [](const auto&... one) {
                return Effects{SlopeForce{}, one...};
            },
            forces.effects().list);
    }
    void resolved(auto& p, const auto& sum) const {
        forces.resolved(p, sum);
        p.A = p.p;
        for (std::size_t i = 0; i < p.size(); ++i) p.V[i] = p.m[i] / p.rho[i];
        sum(Effects{MatrixGradient<>{}});
    }
};

/// CSPM: the density evolves, by corrected slopes of v (the resolution is EvolvedDensity); the force is the
/// corrected slope of P.
struct CspmCure {
    SlopeCure<> force;
    using Columns = SlopeCure<>::Columns;
    using Drift = Velocity;
    auto effects() const { return force.effects(); }
    void resolved(auto& p, const auto& sum) const {
        for (std::size_t i = 0; i < p.size(); ++i) p.V[i] = p.m[i] / p.rho[i], p.drho_dt[i] = 0;
        for (std::size_t a = 0; a < 2; ++a) {
            p.A = p.v[a];
            sum(Effects{MatrixGradient<>{}});
            for (std::size_t i = 0; i < p.size(); ++i) p.drho_dt[i] -= p.rho[i] * p.matrix[a][i];
        }
        force.resolved(p, sum);
    }
};

inline Tensor<2> product(const Tensor<2>& A, const Tensor<2>& B) {
    Tensor<2> AB{};
    for (std::size_t a = 0; a < 2; ++a)
        for (std::size_t b = 0; b < 2; ++b) AB[a][b] = A[a][0] * B[0][b] + A[a][1] * B[1][b];
    return AB;
}

/// The inverses of all CorrectionMatrix, which must have been summed.
void invert_corrections(auto& p) {
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto B = load<2>(p, i, List<CorrectionMatrix>{}).B;
        for (std::size_t b = 0; b < 2; ++b) {
            Vector<2> unit{};
            unit[b] = 1;
            const Vector<2> column = GuardedSolve{}(B, unit, 1.0);
            for (std::size_t a = 0; a < 2; ++a) p.K[a][b][i] = column[a];
        }
    }
}

struct LinearExactCure {
    GentleViscosity damping;
    using Columns = Union<GentleViscosity::Columns, List<Volume, CorrectionMatrix, InverseCorrection>>;
    using Drift = Velocity;
    auto effects() const { return Effects{LinearExactForce{}, damping.effect()}; }
    void resolved(auto& p, const auto& sum) const {
        damping.resolved(p);
        for (std::size_t i = 0; i < p.size(); ++i) p.V[i] = p.m[i] / p.rho[i];
        sum(Effects{CorrectionMatrix{}});
        invert_corrections(p);
    }
};

/// Particles move with XSPH's velocity; forces as listed.
template <class... Force>
struct XsphCure {
    PairCure<Force...> forces;
    double xsph = 0.5;
    using Columns = Union<GentleViscosity::Columns, List<TransportVelocity>>;
    using Drift = TransportVelocity;
    auto effects() const { return forces.effects(); }
    void resolved(auto& p, const auto& sum) const {
        forces.resolved(p, sum);
        sum(Effects{Xsph{.epsilon = xsph}});
    }
};

/// dx/dt = v - strength c h g, less where the limiter says so: min(1, slope (h |g|)^2); slope 0: no limiter.
struct Shift {
    double strength = 0.5, R = 0, W_spacing = 1, slope = 0, h = 1;
    using Columns = List<Volume, DisorderGradient, TransportVelocity>;
    void resolved(auto& p, const auto& sum) const {
        for (std::size_t i = 0; i < p.size(); ++i) p.V[i] = p.m[i] / p.rho[i];
        sum(Effects{DisorderGradient{R, W_spacing}});
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Vector<2> g{p.disorder[0][i], p.disorder[1][i]};
            const double limiter = slope > 0 ? std::min(1.0, slope * h * h * dot(g, g)) : 1;
            for (std::size_t a = 0; a < 2; ++a) p.v_x[a][i] = p.v[a][i] - limiter * strength * h * g[a];
        }
    }
};
/// Particles are shifted; with TransportStress among the forces they also carry their momentum along.
template <class... Force>
struct ShiftCure {
    PairCure<Force...> forces;
    Shift shift;
    using Columns = Union<GentleViscosity::Columns, Shift::Columns>;
    using Drift = TransportVelocity;
    auto effects() const { return forces.effects(); }
    void resolved(auto& p, const auto& sum) const {
        forces.resolved(p, sum);
        shift.resolved(p, sum);
    }
};

using Around = Neighbours<2, Box<2>>;

/// Total Lagrangian: forces on the neighbours of the beginning. No viscosity: it would need the present ones.
/// Not corrected, it has a Lagrangian kernel and no more; hourglass: strength of HourglassForce, of K = 1.
struct ReferenceCure {
    ConstantH<AnyKernel<2>> smoothing;
    Liquid state;
    std::shared_ptr<Around> around;
    bool corrected = true;
    double hourglass = 0;
    std::shared_ptr<sph::Columns<2>> X = std::make_shared<sph::Columns<2>>();
    using Columns = List<Volume, Displacement, CorrectionMatrix, InverseCorrection, DisplacementGradient,
                         ReferenceStress, OtherForce>;
    using Drift = Velocity;
    auto effects() const { return Effects{WithOtherForce{}}; }
    void start(auto& p) const;
    void resolved(auto& p, const auto&) const;
};

/// The balanced background pressure: P_b on a narrow kernel, - P_b on a wide one.
struct BalancedCure {
    using Widths = ConstantH<TwoWidths<AnyKernel<2>, QuinticSpline<2>>>;
    GentleViscosity damping;
    Widths widths;
    BackgroundForce background;
    std::shared_ptr<Around> around;
    using Columns = Union<GentleViscosity::Columns, List<OtherForce, BackgroundPotential>>;
    using Drift = Velocity;
    // [balanced]
    auto effects() const { return Effects{PressureForce<>{}, WithOtherForce{}, damping.effect()}; }
    void resolved(auto& p, const auto&) const {
        damping.resolved(p);
        around->find(p.x, widths.reach());
        sum_over_neighbours(p, *around, widths,
                            Effects{Renamed<BackgroundForce, As<Acceleration, OtherForce>>{background}});
    }
    double energy(const auto& p, std::size_t i) const { return 0.5 * p.phi[i]; }
    // [end]
};

void ReferenceCure::start(auto& p) const {
    *X = p.x;
    around->find(p.x, smoothing.reach());
    for (std::size_t i = 0; i < p.size(); ++i) p.V[i] = p.m[i] / state.rho_0;
    sum_over_neighbours(p, *around, smoothing, Effects{CorrectionMatrix{}});
    if (corrected) return invert_corrections(p);
    for (std::size_t a = 0; a < 2; ++a)
        for (std::size_t b = 0; b < 2; ++b) p.K[a][b].assign(p.size(), a == b ? 1 : 0);
}

void ReferenceCure::resolved(auto& p, const auto&) const {
    for (std::size_t a = 0; a < 2; ++a) {
        for (std::size_t i = 0; i < p.size(); ++i) p.moved[a][i] = p.x[a][i] - (*X)[a][i];
    }
    sum_over_neighbours(p, *around, smoothing, Effects{DisplacementGradient{}});
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto row = load<2>(p, i, List<DisplacementGradient, InverseCorrection>{});
        Tensor<2> F = product(row.H, row.K);
        store<2>(p, i, Row<double, 2, DisplacementGradient>{{F}});
        F[0][0] += 1, F[1][1] += 1;
        const double J = F[0][0] * F[1][1] - F[0][1] * F[1][0];
        p.rho[i] = state.rho_0 / J;
        p.p[i] = state.pressure(p.rho[i]);
        const Tensor<2> cofactor{Vector<2>{F[1][1], -F[1][0]}, Vector<2>{-F[0][1], F[0][0]}};
        const Tensor<2> S = product(p.p[i] * cofactor, row.K);
        for (std::size_t a = 0; a < 2; ++a)
            for (std::size_t b = 0; b < 2; ++b) p.PB[a][b][i] = -S[a][b];
    }
    using Forces = Renamed<ReferenceForce, As<Acceleration, OtherForce>>;
    if (hourglass == 0) return sum_over_neighbours(p, *around, smoothing, Effects{Forces{}});
    sum_over_neighbours(
        p, *around, smoothing,
        Effects{Forces{}, Renamed<HourglassForce, As<Acceleration, OtherForce>>{{.stiffness = hourglass}}});
}

}  // namespace sph::tensile
