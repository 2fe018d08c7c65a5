#pragma once
#include "tests/bench/forces.hpp"

namespace bench {

template <int d>
using GasParticles =
    sph::Particles<d, sph::Position, sph::Velocity, sph::Mass, sph::Density, sph::DensityRate, sph::Pressure,
                   sph::SoundSpeed, sph::ThermalEnergy, sph::Acceleration, sph::Heating>;

/// A periodic box of gas at rest but for noise: a square lattice, jittered, with equal masses, rho = 1, gamma
/// = 5/3 and speed of sound 1. What the benches work on.
template <int d>
struct Gas {
    using Kernel = sph::CubicSpline<d>;
    GasParticles<d> particles;
    sph::ConstantH<Kernel> smoothing;
    sph::Neighbours<d, sph::Box<d>> neighbours;

    Gas(std::size_t per_side, double h_over_dx, int threads = 1)
        : smoothing{h_over_dx / static_cast<double>(per_side)},
          neighbours{sph::periodic_unit_box<d>(), threads} {
        sph::Columns<d> x = sph::make_points<d>(sph::Arrangement::jittered, per_side, 0.2, 1);
        const std::size_t n = x[0].size();
        particles.resize(n);
        particles.x = x;
        sph::Uniform uniform{2};
        for (auto& v : particles.v) {
            for (double& component : v) component = 0.1 * (2 * uniform() - 1);
        }
        particles.m.assign(n, 1.0 / static_cast<double>(n));
        particles.rho.assign(n, 1.0);
        constexpr double gamma = 5.0 / 3;
        particles.p.assign(n, 1 / gamma);
        particles.c_s.assign(n, 1.0);
        particles.u.assign(n, 1 / (gamma * (gamma - 1)));
    }
    void find(sph::Keep keep = sph::Keep::list) {
        neighbours.find(particles.x, smoothing.reach(), sph::Support::gather, keep);
    }
    template <class... E>
    void sum(const sph::Effects<E...>& effects) {
        sph::sum_over_neighbours(particles, neighbours, smoothing, effects);
    }
    double neighbours_each() const {
        return static_cast<double>(neighbours.pairs()) / static_cast<double>(particles.size());
    }
};

}  // namespace bench
