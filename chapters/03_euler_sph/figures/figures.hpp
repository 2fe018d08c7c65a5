#pragma once
#include <string>
#include <vector>

#include "chapters/03_euler_sph/scenes/schemes.hpp"
#include "common/report/chapter.hpp"

/// The figures of this chapter: each function computes, draws, and hands its numbers to the run.
namespace sph::euler {

/// What a reader may change from the command line.
struct Options {
    std::string kernel = "cubic", resolution = "consistent-h", spacing = "graded";
    double h_over_dx = 1.2, gamma = 5.0 / 3, amplitude = 0.5;
    std::vector<double> k_dx{0.1, 0.2, 0.5, 1, 2, 3};
    long particles = 100;
    double time = 5;
    void declare(app::CommandLine& line);
};

void dispersion_figure(report::Run& run);
void wave(report::Run& run);
void forms(report::Run& run);
void reversal(report::Run& run);
void energy(report::Run& run);
void rarefaction(report::Run& run);
void star_modes(report::Run& run);
void star_nonlinear(report::Run& run);
void disc(report::Run& run);
void necklace(report::Run& run);
void patch(report::Run& run);
void hard_case(report::Run& run);
void cost(report::Run& run);
void cost_of_effects(report::Run& run);
// Scenes of the reader's own: scenes.cpp
void dispersion_scene(report::Run& run, const Options& options);
void wave_scene(report::Run& run, const Options& options);
void star_scene(report::Run& run, const Options& options);
void rarefaction_scene(report::Run& run, const Options& options);

/// A scheme as figures and tables call it, and how it is drawn: the same everywhere.
struct Named {
    std::string name, label;
    GasScheme scheme;
    plot::Style style;
};
/// The schemes that are compared: one h, mean h, h without and with Omega, and the best of the chapter, whose
/// h in spacings is `best_h`.
std::vector<Named> compared_schemes(double best_h = 1.35);

inline plot::Style dots(plot::Style style, double size = 3.5) {
    style.width = 0;
    style.marker_size = size;
    return style;
}
inline plot::Style exact_line() {
    return {.label = "exact", .colour = plot::Colour{0, 0, 0}};
}

}  // namespace sph::euler
