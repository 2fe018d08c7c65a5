#pragma once
#include "chapters/03_euler_sph/gas.hpp"

/// Circulation around a necklace of tracers (Monaghan 2005, section 5.1.2) in a two-dimensional flow of a gas
/// with P = K rho^2: a vortex in a periodic box.
namespace sph::euler {

/// dv_l/dt = - grad_l Psi_l, Psi_l = 2 K sum_j m_j W(x_l - x_j)   (5.21 with the factor 2 that belongs to
/// it): tracers feel the gas as its own particles do, but have no mass and are felt by nothing. `twice_K` = 2
/// K.
struct TracerForce {
    double twice_K;
    using ReadsJ = List<Mass>;
    using Adds = List<Acceleration>;
    void add(const auto&, const auto& j, const auto& pair, auto& sum) const {
        sum.dv_dt -= (twice_K * j.m * pair.F) * pair.x_ij;
    }
};
/// sum_j m_j v_j W_ij
struct MomentumDensity {
    static constexpr std::string_view name = "momentum density";
    template <class T, int d>
    struct In {
        Vec<T, d> rho_v{};
    };
    using ReadsJ = List<Mass, Velocity>;
    using Adds = List<MomentumDensity>;
    void add(const auto&, const auto& j, const auto& pair, auto& sum) const {
        sum.rho_v += (j.m * pair.W) * j.v;
    }
};
/// The naive tracer: it moves with the gas's velocity at its place, sum m_j v_j W / sum m_j W.
struct CarriedVelocity {
    using Uses = List<MomentumDensity, SummedDensity>;
    using Writes = List<Velocity>;
    void finish(const auto&, const auto& sum, auto& out) const { out.v = (1 / sum.rho) * sum.rho_v; }
};

struct NecklaceScene {
    std::size_t per_side = 48;  ///< particles of the gas along a side of the box [0, 1)^2
    std::size_t tracers = 1024;
    double radius = 0.15;    ///< of the necklace at t = 0, around the vortex at (1/4, 1/4)
    double mach = 0.3;       ///< of the fastest gas
    double h_over_dx = 2.5;  ///< smoothing length in spacings
    double time = 2;         ///< [box/c_s]
    double courant = 0.3;
    int threads = 1;
};

struct NecklaceRun {
    Column t, circulation, carried;  ///< of tracers that feel forces (5.19), and of those that are carried
    double drift = 0, carried_drift = 0;  ///< largest change, relative
    double energy_drift = 0;              ///< of the gas, relative to its motion at t = 0
    Columns<2> start, end;                ///< the necklace
};
NecklaceRun run_necklace(const NecklaceScene& scene);

}  // namespace sph::euler
