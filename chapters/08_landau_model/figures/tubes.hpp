#pragma once
#include <map>
#include <string>

#include "chapters/08_landau_model/scenes/relativistic_tube.hpp"

namespace sph::landau {

struct TubeFigure {
    std::string name;  ///< of the figure and its table
    TubeScene scene;
    double low, high;  ///< of x in the figure
    /// The classical dissipation: half the particles, an eighth of the time, and noise that amplifies
    /// rounding.
    bool classical_has_half = false;
};
/// A tube by both dissipations, even and disordered, and by the grid: profiles, and a table of errors. One
/// thread: seconds are those of one. Returns the errors by method.
std::map<std::string, report::Quantities> tube_figure(report::Run& run, TubeFigure figure);

}  // namespace sph::landau
