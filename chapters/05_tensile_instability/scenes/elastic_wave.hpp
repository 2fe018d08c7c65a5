#pragma once
#include <string_view>

#include "chapters/05_tensile_instability/scenes/solid.hpp"

/// A plane wave through a periodic strip of solid, K = rho = 1: longitudinal, it travels at c_l =
/// sqrt((K + 4 mu/3)/rho), transverse at c_t = sqrt(mu/rho).
namespace sph::tensile {

enum class Polarisation { longitudinal, transverse };
std::string_view name_of(Polarisation polarisation);  ///< "p", "s", as seismologists call them

struct ElasticWaveScene {
    Polarisation polarisation = Polarisation::longitudinal;
    std::size_t n = 32;       ///< particles along the wave, which is 1 long; >= 8
    std::size_t rows = 6;     ///< across it; periodic
    double shear = 0.22;      ///< mu [K]
    double amplitude = 1e-6;  ///< of the velocity
    double courant = 0.3;     ///< time step [dx/c_l]
    int threads = 1;

    bool longitudinal() const { return polarisation == Polarisation::longitudinal; }
    double spacing() const { return 1 / static_cast<double>(n); }
    Elastic matter() const { return {1, shear, 1}; }
    double speed() const {
        return longitudinal() ? matter().longitudinal_speed() : matter().transverse_speed();
    }
};
struct ElasticWaveRun {
    double error = 0;           ///< largest over a period of sum |v - v_exact| / sum of its amplitude
    double momentum_drift = 0;  ///< over mass times amplitude
    double seconds = 0;         ///< CPU time of the steps
    Counters counters;
    report::Quantities measured() const;
};
/// sum |v - start cos(phase)| / sum |start|, over all places.
double standing_error(const Column& v, const Column& start, double phase);
/// A standing wave, v = amplitude sin(2 pi x) cos(2 pi c t), over one period. Throws Unstable.
ElasticWaveRun run_elastic_wave(const ElasticWaveScene& scene, const SolidMethod& method);

}  // namespace sph::tensile
