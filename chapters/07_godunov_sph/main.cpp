// Chapter 7. Godunov SPH: what does a Riemann solver between particles buy, and what does it cost?
// Figures: renders/07_godunov_sph/. Text: README.md.
#include "chapters/07_godunov_sph/scenes/commands.hpp"
#include "chapters/07_godunov_sph/scenes/sedov.hpp"
#include "chapters/07_godunov_sph/scenes/wedge_command.hpp"
#include "revision.hpp"

namespace sph::godunov {  // figures/, each in a file of its name
void partition(report::Run& run);
void uniform_pressure(report::Run& run);
void paper(report::Run& run);
void wave(report::Run& run);
void repairs(report::Run& run);
void survival(report::Run& run);
void hamiltonian(report::Run& run);
void vortices(report::Run& run);
void blasts(report::Run& run);
void walls(report::Run& run);
void wedge(report::Run& run);
void cost(report::Run& run);
void cost_of_effects(report::Run& run);
}  // namespace sph::godunov

int main(int argc, char** argv) {
    using namespace sph::godunov;
    report::Chapter chapter{"07_godunov_sph",
                            "What does a Riemann solver between particles buy, and what does it cost?",
                            source_revision};
    chapter.figure("partition", "what sums over particles make of a constant and of a velocity", partition)
        .figure("uniform-pressure", "forces where there should be none", uniform_pressure)
        .figure("paper", "figures 2 to 8 of the paper, with its parameters", paper)
        .figure("repairs", "the paper's scheme and its repairs, one at a time", repairs)
        .figure("wave", "a standing sound wave: what the scheme is worth where there is no shock", wave)
        .figure("survival", "which schemes finish the hard cases and are right", survival)
        .figure("hamiltonian", "energy without a Riemann problem, against the step", hamiltonian)
        .timed_figure("vortices", "shear, a vortex and sliding streams in the plane", vortices)
        .timed_figure("blasts", "Noh and Sedov in the plane, and Sedov in space", blasts)
        .figure("walls", "images behind the corners of a wall", walls)
        .timed_figure("wedge", "a wedge in a channel at Mach 2, beside a grid and theory", wedge)
        .timed_figure("cost", "error against CPU time, beside chapter 4's methods and grids", cost)
        .timed_figure("cost-of-effects", "what each listed effect costs per pair", cost_of_effects)
        .scene("tube", "two states of your choice, against the exact solution",
               sph::shocks::TubeCommand{tube_kind()})
        .scene("wave", "a standing sound wave, against the exact solution", WaveOfSound{})
        .scene("sedov", "a point blast on a line, in the plane or in space", SedovInSpace{})
        .scene("wedge", "a wedge of your choice in a channel", WedgeCommand{});
    return chapter.main(argc, argv);
}
