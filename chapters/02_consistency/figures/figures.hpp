#pragma once
#include <string>

#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/02_consistency/scenes/measured.hpp"

/// The figures of this chapter: each function computes, draws, and hands its numbers to the run.
namespace sph::consistency {

/// What a reader may change from the command line.
struct Options {
    std::string kernel = "quintic";
    double h_over_dx = 1.2;
    double jitter = 0.2;  // [spacings]
    long particles = 64;  // along each side of the box
    long dimension = 1;
    std::string arrangement = "jittered";
    std::string volumes = "summed";
    std::string function = "wave";
    void declare(app::CommandLine& line);
    ParticleSet set(const report::Run& run) const;
};

void moments(report::Run& run, const Options& options);
void polynomials(report::Run& run, const Options& options);
void two_gaussians(report::Run& run);
void step(report::Run& run);
void convergence(report::Run& run, const Options& options);
void convergence_2d(report::Run& run, const Options& options);
void maps(report::Run& run, const Options& options);
void smoothing_lengths(report::Run& run);
void hard_case(report::Run& run);
void cost(report::Run& run);
void cost_of_schemes(report::Run& run);
void interpolate(report::Run& run, const Options& options);

/// How a scheme is drawn, the same in every figure: `index` is its place in schemes<2>().
template <int d>
plot::Style scheme_style(const Scheme<d>& scheme) {
    const auto all = schemes<2>();
    std::size_t index = 0;
    while (index + 1 < all.size() && all[index].name != scheme.name) ++index;
    using plot::Marker;
    constexpr std::array shapes{Marker::square, Marker::triangle_up, Marker::plus,
                                Marker::circle, Marker::diamond,     Marker::triangle_down};
    return {.label = scheme.label, .colour = plot::cycle(index), .marker = shapes.at(index)};
}

}  // namespace sph::consistency
