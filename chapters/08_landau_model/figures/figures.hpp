#pragma once
#include <string>
#include <vector>

#include "chapters/08_landau_model/scenes/relativistic_tube.hpp"
#include "chapters/08_landau_model/scenes/slab.hpp"
#include "common/report/chapter.hpp"

/// The figures of this chapter: each function computes, draws, and hands its numbers to the run.
namespace sph::landau {

/// What a reader may change from the command line.
struct Options {
    std::vector<double> left{10, 0, 13.33}, right{1, 0, 1e-8};
    double gamma = 5.0 / 3, time = 0, jitter = 0, courant = 0;
    long particles = 1000;
    std::string method;
    void declare(app::CommandLine& line);
};

// All on one thread: a line of particles is too short for two, and seconds are those of one.
void early(report::Run& run);
void slab(report::Run& run);
void edge(report::Run& run);
void methods(report::Run& run);
void slab_cost(report::Run& run);
void drift(report::Run& run);
void recovery(report::Run& run);
void problem_1(report::Run& run);
void problem_2(report::Run& run);
void collision(report::Run& run);
void tube_cost(report::Run& run);
void survival(report::Run& run);
void slab_scene(report::Run& run, const Options& options);
void tube_scene(report::Run& run, const Options& options);

/// The step that figures of errors take: the errors are those of the default step to 3 %, in a sixth of its
/// time; what the default buys is the energy.
inline constexpr double fast_courant = 0.5;

inline plot::Style exact_line() {
    return {.label = "exact", .colour = plot::Colour{0, 0, 0}};
}
inline plot::Style grid_line() {
    return {.label = "grid", .colour = plot::Colour{0, 0, 0}, .marker = plot::Marker::cross};
}
/// "< 1e-9": the power of ten above |value|. A drift of rounding has no digits that another compiler would
/// repeat.
std::string below(double value);
/// Marti & Mueller's problems, with p_R = 1e-8 in the first, and two cold streams of lorentz 20.
TubeScene problem(int which);
TubeScene streams(double lorentz = 20, double p = 1e-3, double gamma = 4.0 / 3);

}  // namespace sph::landau
