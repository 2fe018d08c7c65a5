#pragma once
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "common/plot/figure.hpp"
#include "common/report/chapter.hpp"

/// What accuracy costs: contestants run one problem at several sizes; error against CPU seconds and against
/// pairs, at equal error and at equal time.
namespace report {

/// One run of a contestant.
struct Lap {
    double error = 0, seconds = 0;  ///< 0 seconds: not measured
    double pairs = 0;               ///< that explain the seconds and are the same everywhere; 0: not counted
    Quantities more{};              ///< what else it measured: rows of results.csv
};
struct Contestant {
    std::string name;   ///< in results.csv
    std::string label;  ///< in figures and tables
    plot::Style look;
    std::function<Lap(std::size_t n)> run;  ///< may throw app::UnphysicalError: then that lap is left out
    std::vector<std::size_t> sizes{};       ///< its own; empty: those of the race
};
struct RaceCourse {
    std::string name{};  ///< before the contestants' names in results.csv; may be empty
    std::vector<std::size_t> sizes{};
    std::string quantity = "error";  ///< what results.csv calls the error
    int repeats = 3;                 ///< the least seconds of so many laps count; once if quick or checking
    double repeat_below = std::numeric_limits<double>::infinity();  ///< [s] longer laps are run once
};

/// What a curve says at a place: a value, a bound where the place lies before its first point, or nothing.
struct Reading {
    enum class Kind { value, at_most, not_reached, not_in_time } kind = Kind::not_reached;
    double value = 0;
    /// "≈2.4", "≤ ≈2.4", "not reached"; "≈ no run" where none is so short on this machine.
    std::string text(double factor = 1) const;
};

/// The laps of one contestant, from the smallest size on.
struct Track {
    Contestant who;
    std::string quantity{};  ///< what the error is
    std::vector<std::size_t> n{};
    plot::Values error{}, seconds{}, pairs{};
    std::vector<Quantities> more{};
    std::vector<std::string> left_out{};  ///< "N = 50: unphysical state at ..."

    /// All that lap k measured, as the rows of results.csv name it.
    Quantities lap(std::size_t k) const;
    plot::Values sizes() const { return {n.begin(), n.end()}; }
    /// The seconds at which the error falls to the bound, between two laps on a logarithmic scale. Where the
    /// first lap is below it already, its seconds are a bound; where an error rises, the lap before counts.
    Reading seconds_at_error(double bound) const;
    /// The least error that is to be had in so many seconds; a bound where the last lap takes less, and
    /// nothing where the first takes more.
    Reading error_in_seconds(double seconds) const;
    /// The first lap whose error is at most the bound, or n.size().
    std::size_t first_below(double bound) const;
    double order() const;  ///< fitted to all laps
};

/// Runs all contestants over their sizes. Rows of results.csv: the quantity, what else a lap measured, and
/// pairs and cpu_seconds where they are counted.
std::vector<Track> race(Run& run, const RaceCourse& course, const std::vector<Contestant>& contestants);

/// Each track as a curve in its look. Where `spoken_of` names some, the others are thin and grey, under one
/// entry of the legend.
void draw_error_against_seconds(plot::Panel& panel, const std::vector<Track>& tracks,
                                const std::vector<std::string>& spoken_of = {});
void draw_error_against_size(plot::Panel& panel, const std::vector<Track>& tracks,
                             const std::vector<std::string>& spoken_of = {});

}  // namespace report
