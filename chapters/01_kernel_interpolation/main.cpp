// Chapter 1. Kernel interpolation: how well does a sum over particles stand for a function and its
// derivatives? Figures: renders/01_kernel_interpolation/. Text: README.md.
#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "revision.hpp"

int main(int argc, char** argv) {
    using namespace sph;
    using report::Run;
    report::Chapter chapter{
        "01_kernel_interpolation",
        "How well does a sum over particles stand for a function and its derivatives, and what "
        "sets the error?",
        source_revision};
    Options options;
    options.declare(chapter.options());

    chapter.figure("kernels", "nine kernels and their derivatives", kernel_shapes)
        .figure("fourier", "their Fourier transforms against the closed forms", fourier_transforms)
        .figure("interpolation", "a test function and its derivatives, even and jittered particles",
                [&](Run& run) { test_function(run, options); })
        .figure("integral-error", "error of the integral interpolant against h, in 1, 2 and 3 dimensions",
                integral_errors)
        .figure("summation-error", "error of sums over even particles against h/dx, on Poisson's formula",
                summation_errors)
        .figure("convergence", "error against N on even, jittered and random particles",
                [&](Run& run) { convergence(run, options); })
        .figure("second-derivatives", "hard case: the twice differentiated sum against Brookshaw's form",
                [&](Run& run) { second_derivatives(run, options); })
        .figure("map", "a 2D interpolant and its error", [&](Run& run) { interpolation_map(run, options); })
        .figure("cost", "error against nanoseconds a point: kernels, h/dx, finite differences", cost)
        .figure("cost-of-resolution", "error against CPU seconds over the number of particles",
                cost_of_resolution)
        .figure("cost-of-estimates", "what each estimate adds to the cost of a point", cost_of_estimates)
        .scene("interpolate", "the test function with your kernel, h, particles: profile.csv, results.csv",
               [&](Run& run) { interpolate(run, options); })
        .scene("kernel", "W, its derivatives and F against q as CSV on standard output",
               [&](Run& run) { tabulate(run, options); });
    return chapter.main(argc, argv);
}
