#pragma once
#include <functional>

#include "chapters/04_artificial_viscosity/scenes/methods.hpp"

/// A standing sound wave in a periodic box of length 1, rho = 1, c_s = 1, gamma = 1.4: what a dissipation
/// costs where there is no shock.
namespace sph::shocks {

struct StandingWave {
    std::size_t n = 64;
    double amplitude = 1e-6;  ///< of the velocity [c_s]
    double courant = 0.45;
    int threads = 1;
    std::function<void(const Simulation<1>& gas)> watch{};  ///< called after each step
};
struct StandingWaveRun {
    double error = 0;        ///< largest over one period of sum |v - v_exact| / sum of its amplitude
    double energy_left = 0;  ///< the wave's energy after the period over that before, from max |v|^2
    double seconds = 0;      ///< CPU
    Counters counters;
};

/// One period. Throws Unstable.
StandingWaveRun run_standing_wave(const StandingWave& scene, const Method<1>& method);

}  // namespace sph::shocks
