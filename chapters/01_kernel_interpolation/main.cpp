// Chapter 1. Kernel interpolation: how well does a sum over particles stand for a function and its
// derivatives? Figures: renders/01_kernel_interpolation/. Text: README.md.
#include "chapters/01_kernel_interpolation/scenes/interpolate.hpp"
#include "chapters/01_kernel_interpolation/scenes/kernel.hpp"
#include "revision.hpp"

namespace sph::interpolation {  // figures/, each in a file of its name; a Task takes options
void support(report::Run& run);
void two_errors(report::Run& run);
void kernels(report::Run& run);
void fourier(report::Run& run);
report::Task interpolation();
void integral_error(report::Run& run);
void summation_error(report::Run& run);
report::Task convergence();
report::Task second_derivatives();
report::Task map();
void cost(report::Run& run);
void cost_of_resolution(report::Run& run);
void cost_of_estimates(report::Run& run);
}  // namespace sph::interpolation

int main(int argc, char** argv) {
    using namespace sph::interpolation;
    report::Chapter chapter{
        "01_kernel_interpolation",
        "How well does a sum over particles stand for a function and its derivatives, and what "
        "sets the error?",
        source_revision};

    chapter.figure("support", "who is summed, and what is summed", support)
        .figure("two-errors", "smoothing and sampling apart: errors of a wave against h/dx", two_errors)
        .figure("kernels", "nine kernels and their derivatives", kernels)
        .figure("fourier", "their Fourier transforms against the closed forms", fourier)
        .figure("interpolation", "a test function and its derivatives, even and jittered particles",
                interpolation())
        .figure("integral-error", "error of the integral interpolant against h, in 1, 2 and 3 dimensions",
                integral_error)
        .figure("summation-error", "error of sums over even particles against h/dx, on Poisson's formula",
                summation_error)
        .figure("convergence", "error against N on even, jittered and random particles", convergence())
        .figure("second-derivatives", "hard case: the twice differentiated sum against Brookshaw's form",
                second_derivatives())
        .figure("map", "a 2D interpolant and its error", map())
        .timed_figure("cost", "error against nanoseconds a point: kernels, h/dx, finite differences", cost)
        .timed_figure("cost-of-resolution", "error against CPU seconds over the number of particles",
                      cost_of_resolution)
        .timed_figure("cost-of-estimates", "what each estimate adds to the cost of a point",
                      cost_of_estimates)
        .scene("interpolate", "the test function with your kernel, h, particles: profile.csv, results.csv",
               InterpolateCommand{})
        .scene("kernel", "W, its derivatives and F against q as CSV on standard output", KernelCommand{});
    return chapter.main(argc, argv);
}
