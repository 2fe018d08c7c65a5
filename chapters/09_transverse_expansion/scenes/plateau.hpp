#pragma once
#include "chapters/09_transverse_expansion/scenes/expansion.hpp"

/// The cylinder in three dimensions (tau, x, y, eta), with ends in eta: is its middle the cylinder of the
/// plane?
namespace sph::transverse {

struct PlateauScene {
    std::size_t per_layer = 800;  ///< particles of each layer of one eta
    double half = 1.6;            ///< the plateau is |eta| < half, vacuum beyond
    double time = 4;
    double courant = 0.7;
    int threads = 1;
    static constexpr double R = 10, tau0 = 1;
};
struct PlateauRun {
    std::size_t n = 0;
    Column r, temperature, u_r, eta_velocity;  ///< of the layers next to eta = 0
    Column plane_r, plane_temperature;         ///< the plane's run with as many particles as a layer
    Column rings_r, rings, plane_rings;        ///< means of T over rings of width 1 in r < R
    double difference = 0;                     ///< by area, of the rings: sum |T - T_plane| dA/sum T_plane dA
    double l1_temperature = 0;                 ///< against the characteristics, r < R
    double plane_l1_temperature = 0;
    double seconds = 0;
    Counters counters;
};
PlateauRun run_plateau(const PlateauScene& scene);

}  // namespace sph::transverse
