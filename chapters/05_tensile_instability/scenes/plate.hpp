#pragma once
#include "chapters/05_tensile_instability/scenes/solid.hpp"
#include "common/exact/plate.hpp"

/// A long plate, clamped at x = 0 and free at x = L, in plane strain: it swings, or carries a load at its
/// end. K = rho = 1, thickness 1.
namespace sph::tensile {

struct PlateScene {
    std::size_t rows = 6;  ///< particles across the plate; >= 3
    double aspect = 10;    ///< length over thickness; >= 4
    double shear = 0.22;   ///< mu [K]; Poisson's ratio is then 0.40
    double speed = 1e-3;   ///< scale of the first velocity [sqrt(K/rho)]
    double courant = 0.8;
    int threads = 1;
};

struct PlateRun {
    double frequency = 0;  ///< over that of thin-plate theory; 0: it did not swing back
    Column t, swing;       ///< time in exact periods, and the part of the displacement that is the first mode
    Counters counters;
    report::Quantities measured() const;
};
/// Half a swing in the first mode. The particles of the clamp are one column at x = 0, the free ones follow
/// at dx, 2 dx, ... Throws Unstable.
PlateRun run_plate(const PlateScene& scene, const SolidMethod& method);

struct BeamRun {
    double deflection = 0;  ///< of the loaded end, over w L^3/(3 E' I)
    double speed = 0;       ///< largest at the end, over the deflection times the first frequency
    Counters counters;
    report::Quantities measured() const;
};
/// The same plate, total Lagrangian, with the force w = 1e-6 (per depth) on its last column and friction
/// until it rests. Throws Unstable.
BeamRun run_beam(const PlateScene& scene);

/// Thin-plate theory for the scene's plate.
exact::ClampedPlate exact_plate(const PlateScene& scene);

}  // namespace sph::tensile
