#pragma once
#include "chapters/03_euler_sph/gas.hpp"
#include "common/report/chapter.hpp"

/// A square of liquid that its own motion distorts (Colagrossi 2004; Monaghan 2005, 2.46 and figure 5).
namespace sph::euler {

struct PatchScene {
    std::size_t per_side = 40;
    double sound_speed = 10;  ///< in units of V
    double time = 0.6;        ///< [L/V]
    double courant = 0.3;
    int threads = 1;
};

struct PatchRun {
    Columns<2> x, middle_x;  ///< at the end and at half the time
    Column pressure, middle_pressure;
    double momentum = 0;          ///< largest change of a component over sum m |v|
    double angular_momentum = 0;  ///< largest change over sum m |x| |v|
    Column t, energy;             ///< change of kinetic + internal energy, relative to the motion at t = 0
    double energy_drift = 0;
    double compression = 0;  ///< largest |rho/rho_0 - 1|
    Counters counters;

    report::Quantities measured() const;
};
PatchRun run_patch(const PatchScene& scene);

}  // namespace sph::euler
