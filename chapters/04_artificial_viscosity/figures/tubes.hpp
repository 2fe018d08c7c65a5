#pragma once
#include <string>
#include <vector>

#include "chapters/04_artificial_viscosity/scenes/tube.hpp"

/// Figures of one tube: every method, beside both grids.
namespace sph::shocks {

struct TubeFigure {
    std::string name;  ///< of the figure and of its table
    TubeScene scene;
    std::vector<std::string> more{};   ///< methods of the table beside tube_contestants()
    std::vector<std::string> drawn{};  ///< methods
    double low = -0.5, high = 0.5;     ///< of x in the figure
    std::string block{};               ///< of the table of several N
    std::vector<std::size_t> sizes{};
    std::vector<std::string> compared{"signal", "reconstructed"};  ///< methods, over these N
};
using TubeRuns = std::vector<std::pair<Method<1>, TubeRun>>;
/// The run of the method of that name, which must be there.
const TubeRun& run_of(const TubeRuns& runs, const std::string& name);

/// The table of all methods, and the one over several N; `quick_n` particles if quick, and no table of
/// several N. Returns the runs.
TubeRuns tube_tables(report::Run& run, TubeFigure figure, std::size_t quick_n);
/// These, and the profiles of those that are drawn.
TubeRuns tube_figure(report::Run& run, TubeFigure figure, std::size_t quick_n);

}  // namespace sph::shocks
