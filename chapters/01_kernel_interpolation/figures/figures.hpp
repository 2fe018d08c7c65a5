#pragma once
#include <string>

#include "chapters/01_kernel_interpolation/scenes/particles.hpp"
#include "common/plot/figure.hpp"
#include "common/report/chapter.hpp"

/// The figures of this chapter: each function computes, draws, and hands its numbers to the run.
namespace sph {

/// What a reader may change from the command line.
struct Options {
    std::string kernel = "cubic";
    double h_over_dx = 1.2;
    double jitter = 0.2;  // [spacings]
    long particles = 32;  // along each side of the box
    long dimension = 1;
    std::string arrangement = "jittered";
    void declare(app::CommandLine& line);
};
Arrangement arrangement_named(const std::string& name);

void kernel_shapes(report::Run& run);
void fourier_transforms(report::Run& run);
void integral_errors(report::Run& run);
void summation_errors(report::Run& run);
void test_function(report::Run& run, const Options& options);
void interpolation_map(report::Run& run, const Options& options);
void convergence(report::Run& run, const Options& options);
void second_derivatives(report::Run& run, const Options& options);
void cost(report::Run& run);
void cost_of_resolution(report::Run& run);
void cost_of_estimates(report::Run& run);
void interpolate(report::Run& run, const Options& options);
void tabulate(report::Run& run, const Options& options);

/// Line style of a kernel, the same in every figure: `index` is its place in Kernels<d>.
plot::Style kernel_style(std::size_t index, const std::string& label, bool markers = false);
/// A kernel's name as a label: "cubic spline", "Wendland $C$^{2}".
std::string kernel_label(std::string_view name);

/// `count` values from low to high, evenly or in equal ratios (low > 0). count >= 2.
plot::Values linear_space(double low, double high, std::size_t count);
plot::Values log_space(double low, double high, std::size_t count);

}  // namespace sph
