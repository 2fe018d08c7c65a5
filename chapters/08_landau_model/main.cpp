// Chapter 8. The Landau model: relativistic, entropy-based SPH, followed into the vacuum.
// Figures: renders/08_landau_model/. Text: README.md.
#include "chapters/08_landau_model/figures/figures.hpp"
#include "revision.hpp"

int main(int argc, char** argv) {
    using namespace sph::landau;
    using report::Run;
    report::Chapter chapter{"08_landau_model",
                            "How is relativistic, entropy-based SPH derived, and does it follow Landau's and "
                            "Khalatnikov's solution into the vacuum?",
                            source_revision};
    Options options;
    options.declare(chapter.options());

    chapter.figure("early", "the slab until its waves meet: Riemann's simple wave", early)
        .figure("slab", "the slab from t = 2 to 10: Khalatnikov's solution between simple waves", slab)
        .figure("edge", "the edge of the vacuum, magnified", edge)
        .figure("methods", "what smoothing lengths and grading do to the slab's error", methods)
        .figure("slab-cost", "error of the slab against CPU time, beside a grid", slab_cost)
        .figure("drift", "energy against the time step, with and without the terms of a varying h", drift)
        .figure("recovery", "the velocity from the momentum, up to lorentz 1e6", recovery)
        .figure("problem-1", "Marti and Mueller's first blast", problem_1)
        .figure("problem-2", "Marti and Mueller's second blast: a thin shell", problem_2)
        .figure("collision", "two streams of lorentz 20 that meet", collision)
        .figure("tube-cost", "error of the blasts against CPU time, beside a grid", tube_cost)
        .figure("survival", "which methods finish the hard cases", survival)
        .scene("slab", "the slab with particles, time and method of your choice",
               [&](Run& run) { slab_scene(run, options); })
        .scene("tube", "two relativistic states of your choice, against the exact solution",
               [&](Run& run) { tube_scene(run, options); });
    return chapter.main(argc, argv);
}
