#pragma once
#include <string>
#include <vector>

#include "chapters/04_artificial_viscosity/scenes/tube.hpp"

/// Figures of one tube: every method, beside both grids.
namespace sph::shocks {

struct TubeFigure {
    std::string name;  ///< of the figure and of its table
    TubeScene scene;
    std::vector<std::string> drawn;  ///< methods
    double low = -0.5, high = 0.5;   ///< of x in the figure
    std::string block{};             ///< of the table of several N
    std::vector<std::size_t> sizes{};
    std::vector<std::string> compared{"signal", "reconstructed"};  ///< methods, over these N
};
/// The profiles, the table of all methods, and the one over several N; `quick_n` particles if quick, and no
/// table of several N.
void tube_figure(report::Run& run, TubeFigure figure, std::size_t quick_n);

}  // namespace sph::shocks
