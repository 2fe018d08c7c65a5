#pragma once
#include <string>

#include "chapters/04_artificial_viscosity/scenes/tube.hpp"

/// Sod's tube by one method: velocity, and what only a shock may change.
namespace sph::shocks {

/// What a method makes of the gas between contact and shock, relative.
struct Entropies {
    double noise = 0;         ///< the largest error of a velocity
    double gain = 0;          ///< of P/rho^gamma, in the mean
    double largest_gain = 0;  ///< of any particle; 0 at least
    double due = 0;           ///< what the exact solution gains
};
/// Of a run of Sod's tube, five hundredths away from contact and shock.
Entropies between_contact_and_shock(const TubeRun& tube, const TubeScene& scene);
/// Draws the figure, and hands over rows and the numbers of the text.
Entropies follow_entropy(report::Run& run, const std::string& method, const std::string& figure);

}  // namespace sph::shocks
