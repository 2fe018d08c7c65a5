// Chapter 8. The Landau model: relativistic, entropy-based SPH, followed into the vacuum.
// Figures: renders/08_landau_model/. Text: README.md.
#include "chapters/08_landau_model/scenes/relativistic_tube.hpp"
#include "chapters/08_landau_model/scenes/slab.hpp"
#include "revision.hpp"

namespace sph::landau {  // figures/, each in a file of its name
void x_t(report::Run& run);
void thesis(report::Run& run);
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
}  // namespace sph::landau

int main(int argc, char** argv) {
    using namespace sph::landau;
    report::Chapter chapter{"08_landau_model",
                            "How is relativistic, entropy-based SPH derived, and does it follow Landau's and "
                            "Khalatnikov's solution into the vacuum?",
                            source_revision};
    chapter.figure("x-t", "the slab in the plane of place and time: light cone, waves, world lines", x_t)
        .figure("thesis", "even particles with one h: the thesis' figure 25", thesis)
        .figure("early", "the slab until its waves meet: Riemann's simple wave", early)
        .figure("slab", "the slab from t = 2 to 10: Khalatnikov's solution between simple waves", slab)
        .figure("edge", "the edge of the vacuum, magnified", edge)
        .timed_figure("methods", "what smoothing lengths and grading do to the slab's error", methods)
        .timed_figure("slab-cost", "error of the slab against CPU time, beside a grid", slab_cost)
        .figure("drift", "energy against the time step, with and without the terms of a varying h", drift)
        .figure("recovery", "the velocity from the momentum, up to lorentz 1e6", recovery)
        .timed_figure("problem-1", "Marti and Mueller's first blast", problem_1)
        .timed_figure("problem-2", "Marti and Mueller's second blast: a thin shell", problem_2)
        .timed_figure("collision", "two streams of lorentz 20 that meet", collision)
        .timed_figure("tube-cost", "error of the blasts against CPU time, beside a grid", tube_cost)
        .figure("survival", "which methods finish the hard cases", survival)
        .scene("slab", "the slab with particles, time and method of your choice", SlabCommand{})
        .scene("tube", "two relativistic states of your choice, against the exact solution",
               sph::shocks::TubeCommand{relativistic_kind()});
    return chapter.main(argc, argv);
}
