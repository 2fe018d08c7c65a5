#pragma once
#include "chapters/01_kernel_interpolation/interpolation.hpp"

/// A full set of forces for the benches; chapters 3 and 4 derive them.
namespace bench {

using sph::square;

/// drho_i/dt = sum_j m_j v_ij . grad_i W_ij   (Monaghan 2005, 2.17)
struct Continuity {
    using Reads = sph::List<sph::Velocity>;
    using ReadsJ = sph::List<sph::Mass>;
    using Adds = sph::List<sph::DensityRate>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.drho_dt += j.m * pair.F * dot(i.v - j.v, pair.x_ij);
    }
};

/// dv_i/dt = - sum_j m_j (p_i/rho_i^2 + p_j/rho_j^2) grad_i W_ij   (3.8)
struct PressureForce {
    using Reads = sph::List<sph::Density, sph::Pressure>;
    using ReadsJ = sph::List<sph::Mass>;
    using Adds = sph::List<sph::Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.dv_dt -= (j.m * (i.p / square(i.rho) + j.p / square(j.rho)) * pair.F) * pair.x_ij;
    }
};

/// du_i/dt = p_i/rho_i^2 sum_j m_j v_ij . grad_i W_ij   (3.14)
struct PressureHeating {
    using Reads = sph::List<sph::Velocity>;
    using ReadsI = sph::List<sph::Density, sph::Pressure>;
    using ReadsJ = sph::List<sph::Mass>;
    using Adds = sph::List<sph::Heating>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.du_dt += (i.p / square(i.rho)) * j.m * pair.F * dot(i.v - j.v, pair.x_ij);
    }
};

/// Pi_ij = (-alpha c_ij mu_ij + beta mu_ij^2) / rho_ij for approaching particles, with the heat that it makes
/// (8.10; Monaghan 1992).
struct ArtificialViscosity {
    double alpha = 1, beta = 2;
    using Reads = sph::List<sph::Velocity, sph::Density, sph::SoundSpeed>;
    using ReadsJ = sph::List<sph::Mass>;
    using Adds = sph::List<sph::Acceleration, sph::Heating>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        constexpr double softening = 0.01;  // of h^2: coincident particles
        const sph::Tile approach = dot(i.v - j.v, pair.x_ij);
        const sph::Tile mu =
            pair.h * approach.min(0.0) / (dot(pair.x_ij, pair.x_ij) + softening * square(pair.h));
        const sph::Tile Pi = mu * (beta * mu - alpha * 0.5 * (i.c_s + j.c_s)) / (0.5 * (i.rho + j.rho));
        const sph::Tile force = j.m * Pi * pair.F;
        sum.dv_dt -= force * pair.x_ij;
        sum.du_dt += 0.5 * force * approach;
    }
};

/// Arithmetic operations of all of the above and the summed density in 3D, a division or root counted as one:
/// x_ij 3, r 6, q 1, W 9, F 8, density 2, v_ij 3, v_ij.x_ij 5, continuity 3, pressure 3, viscosity 12, the
/// force 8, heating 5. In 2D: 61.
template <int d>
constexpr double operations_a_pair = d == 3 ? 68 : 61;

inline auto all_forces() {
    return sph::Effects{sph::SummedDensity{}, Continuity{}, PressureForce{}, PressureHeating{},
                        ArtificialViscosity{}};
}

}  // namespace bench
