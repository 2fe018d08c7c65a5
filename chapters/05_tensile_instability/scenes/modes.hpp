#pragma once
#include "chapters/05_tensile_instability/scenes/lattice_box.hpp"
#include "chapters/05_tensile_instability/scenes/lattice_growth.hpp"

/// One wave of displacements on the lattice, followed in time: what the dispersion matrix predicts, and what
/// particles do.
namespace sph::tensile {

/// omega^2 of a wave, below 0 where it grows at the rate sqrt(-omega^2)   [(c/dx)^2].
struct ModeRun {
    double predicted = 0;  ///< the smaller eigenvalue of the dispersion matrix
    double measured = 0;
    long steps = 0;

    double relative_error() const { return std::abs(measured / predicted - 1); }
    /// Of the rate or of the frequency: half of that of their squares.
    double rate_error() const { return std::abs(std::sqrt(measured / predicted) - 1); }
};

/// Runs the wave `box.wave.waves` of the box, displaced along the slower of its two directions by 1e-6
/// spacings, from rest: until a growing one has grown threefold (faster ones, which rounding seeds, are then
/// still small), or an oscillating one passes through zero. The time step's own error is known and taken out.
/// Throws Unstable.
ModeRun run_mode(LatticeBox box);

}  // namespace sph::tensile
