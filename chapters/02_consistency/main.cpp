// Chapter 2. Consistency: why does SPH not even reproduce a constant near a boundary or on disordered
// particles, and what restores it? Figures: renders/02_consistency/. Text: README.md.
#include "chapters/02_consistency/figures/figures.hpp"
#include "revision.hpp"

int main(int argc, char** argv) {
    using namespace sph::consistency;
    using report::Run;
    report::Chapter chapter{
        "02_consistency",
        "Why does SPH not even reproduce a constant near a boundary or on disordered particles, and "
        "what restores it?",
        source_revision};
    Options options;
    options.declare(chapter.options());

    chapter
        .figure("moments", "what sums make of 1, x and x^2, on disorder and at an end",
                [&](Run& run) { moments(run, options); })
        .figure("polynomials", "a constant, a line and a parabola as each scheme sees them",
                [&](Run& run) { polynomials(run, options); })
        .figure("two-gaussians", "a sum of two Gaussians on 1000 random particles", two_gaussians)
        .figure("convergence", "errors of values and slopes against N in 1D, inside",
                [&](Run& run) { convergence(run, options); })
        .figure("convergence-2d", "the same in 2D", [&](Run& run) { convergence_2d(run, options); })
        .figure("maps", "where the slope is wrong in 2D", [&](Run& run) { maps(run, options); })
        .figure("step", "a step: SPH, CSPM and DSPH", step)
        .figure("smoothing-lengths", "one h, or one a particle, on a line whose density rises tenfold",
                smoothing_lengths)
        .figure("hard-case", "hard case: neighbours that do not determine a slope", hard_case)
        .figure("cost", "error against CPU time, beside differences", cost)
        .figure("cost-of-schemes", "what each scheme adds to the cost of a point", cost_of_schemes)
        .scene("interpolate",
               "a function with your kernel, h and particles by every scheme: profile.csv, results.csv",
               [&](Run& run) { interpolate(run, options); });
    return chapter.main(argc, argv);
}
