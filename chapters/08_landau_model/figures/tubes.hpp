#pragma once
#include <map>
#include <string>
#include <vector>

#include "chapters/08_landau_model/scenes/relativistic_tube.hpp"

namespace sph::landau {

/// What a panel of a tube's figure shows: a quantity in a part of the tube.
struct TubePanel {
    std::string title, label;
    Column shocks::Profile::*quantity;
    double low, high;  ///< of x
    bool log_y = false;
};

struct TubeFigure {
    std::string name;  ///< of the figure and its table
    TubeScene scene;
    std::vector<TubePanel> panels;  ///< four
    /// The classical dissipation leaves noise that amplifies rounding: its digits are not compared.
    bool classical_is_noisy = false;
    bool with_story = true;  ///< a short table of the drawn runs, too
};
/// A run of a tube by one way, and where its shock is.
struct TubeEntry {
    std::string name, label;
    plot::Style look;
    std::size_t n;  ///< its own: some runs have half the scene's
    TubeRun run;
    Shock shock{};
    bool drawn = true, noisy = false;
    report::Quantities errors() const;
};
using TubeEntries = std::vector<TubeEntry>;
/// Throws std::out_of_range for a name that is not there.
const TubeEntry& entry_of(const TubeEntries& entries, const std::string& name);

/// A tube by both dissipations, even and disordered, and by the grid: profiles, and a table of errors under
/// the figure's name; if wanted, a shorter one of the drawn runs under name + "-story". One thread: seconds
/// are those of one.
TubeEntries tube_figure(report::Run& run, TubeFigure figure);

}  // namespace sph::landau
