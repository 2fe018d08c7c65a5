#pragma once
#include "chapters/05_tensile_instability/scenes/lattice_box.hpp"

/// Does disorder decay? A jittered lattice under pressure, with friction or without, beside the linear
/// theory.
namespace sph::tensile {

struct DisorderedBox {
    LatticeBox box{.per_side = 20, .pressure = 0.2, .jitter = 0.1};
    double friction = 0.5;  ///< nu of dv/dt = ... - nu v   [c/dx]
    double time = 60;       ///< [dx/c]
};

struct DisorderRun {
    Column t, measured, predicted;  ///< root mean square distance from the lattice [dx]: particles and theory
    double nearest = 0;             ///< at the end, the smallest distance between two particles [dx]

    /// Mean rates at which the two decay, -ln(last/first)/time   [c/dx]; negative: disorder grows.
    double measured_rate() const { return rate(measured); }
    double predicted_rate() const { return rate(predicted); }

  private:
    double rate(const Column& disorder) const {
        return -std::log(disorder.back() / disorder.front()) / t.back();
    }
};
/// The distance is counted from the nearest lattice that has moved as a whole with the particles' mean.
/// Prediction: each wave of the box by itself, u'' + nu u' + omega^2 u = 0 from rest, with all waves equally
/// strong at the start, as independent shifts make them on average. Throws Unstable.
DisorderRun run_disorder(const DisorderedBox& scene);

}  // namespace sph::tensile
