// Chapter 2. Consistency: why does SPH not even reproduce a constant near a boundary or on disordered
// particles, and what restores it? Figures: renders/02_consistency/. Text: README.md.
#include "chapters/02_consistency/scenes/interpolate.hpp"
#include "revision.hpp"

namespace sph::consistency {  // figures/, each in a file of its name; a Task takes options
void edge(report::Run& run);
report::Task moments();
report::Task polynomials();
void two_gaussians(report::Run& run);
report::Task convergence();
report::Task convergence_2d();
report::Task maps();
void step(report::Run& run);
void smoothing_lengths(report::Run& run);
void hard_case(report::Run& run);
void cost(report::Run& run);
void cost_of_schemes(report::Run& run);
}  // namespace sph::consistency

int main(int argc, char** argv) {
    using namespace sph::consistency;
    report::Chapter chapter{
        "02_consistency",
        "Why does SPH not even reproduce a constant near a boundary or on disordered particles, and "
        "what restores it?",
        source_revision};

    chapter.figure("edge", "a support that an end has cut, and the constant 1 there", edge)
        .figure("moments", "what sums make of 1, x and x^2, on disorder and at an end", moments())
        .figure("polynomials", "a constant, a line and a parabola as each scheme sees them", polynomials())
        .figure("two-gaussians", "a sum of two Gaussians on 1000 random particles", two_gaussians)
        .figure("convergence", "errors of values and slopes against N in 1D, inside", convergence())
        .figure("convergence-2d", "the same in 2D", convergence_2d())
        .figure("maps", "where the slope is wrong in 2D", maps())
        .figure("step", "a step: SPH, CSPM and DSPH", step)
        .figure("smoothing-lengths", "one h, or one a particle, on a line whose density rises tenfold",
                smoothing_lengths)
        .figure("hard-case", "hard case: neighbours that do not determine a slope", hard_case)
        .timed_figure("cost", "error against CPU time, beside differences", cost)
        .timed_figure("cost-of-schemes", "what each scheme adds to the cost of a point", cost_of_schemes)
        .scene("interpolate",
               "a function with your kernel, h and particles by every scheme: profile.csv, results.csv",
               SchemesCommand{});
    return chapter.main(argc, argv);
}
