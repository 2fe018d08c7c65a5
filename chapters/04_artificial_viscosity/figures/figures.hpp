#pragma once
#include <string>
#include <vector>

#include "chapters/04_artificial_viscosity/scenes/tube.hpp"
#include "common/report/chapter.hpp"

/// The figures of this chapter: each function computes, draws, and hands its numbers to the run.
namespace sph::shocks {

/// What a reader may change from the command line.
struct Options {
    std::vector<double> left{1, 0, 1}, right{0.125, 0, 0.1};
    double gamma = 1.4, time = 0.2, jitter = 0, courant = 0.45;
    long particles = 720;
    std::string method;
    bool all_runs = false;
    void declare(app::CommandLine& line);
};

void sod(report::Run& run);
void mach(report::Run& run);
void blast(report::Run& run);
void colliding(report::Run& run);
void expansion(report::Run& run);
void woodward_colella(report::Run& run);
void kernels(report::Run& run);
void viscous_pressures(report::Run& run);
void wave(report::Run& run);
void survival(report::Run& run, bool all_runs);
void cost(report::Run& run);
void cost_of_effects(report::Run& run);
void noh_plane(report::Run& run);
void sedov(report::Run& run);
void shear_layer(report::Run& run);
void viscous(report::Run& run);
void tube_scene(report::Run& run, const Options& options);

/// A method as figures draw it: one look everywhere.
plot::Style style_of(const std::string& method);
/// Methods by name, in the given order.
std::vector<Method> methods_named(const std::vector<std::string>& names);

inline plot::Style dots(plot::Style style, double size = 3.5) {
    style.width = 0;
    style.marker_size = size;
    return style;
}
inline plot::Style exact_line() {
    return {.label = "exact", .colour = plot::Colour{0, 0, 0}};
}

}  // namespace sph::shocks
