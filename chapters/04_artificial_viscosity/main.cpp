// Chapter 4. Artificial viscosity: what lets SPH pass a shock, and what does that cost elsewhere?
// Figures: renders/04_artificial_viscosity/. Text: README.md.
#include "chapters/04_artificial_viscosity/figures/survival.hpp"
#include "chapters/04_artificial_viscosity/scenes/tube_command.hpp"
#include "revision.hpp"

namespace sph::shocks {  // figures/, each in a file of its name
void sod(report::Run& run);
void mach(report::Run& run);
void blast(report::Run& run);
void viscous_pressures(report::Run& run);
void kernels(report::Run& run);
void one_at_a_time(report::Run& run);
void wave(report::Run& run);
void cold_streams(report::Run& run);
void noh(report::Run& run);
void x_t(report::Run& run);
void sod_without(report::Run& run);
void sod_viscous(report::Run& run);
void contact(report::Run& run);
void review_tube(report::Run& run);
void expansion(report::Run& run);
void woodward_colella(report::Run& run);
void noh_plane(report::Run& run);
void sedov(report::Run& run);
void shear_layer(report::Run& run);
void viscous(report::Run& run);
void layers(report::Run& run);
void cost(report::Run& run);
void cost_of_effects(report::Run& run);
}  // namespace sph::shocks

int main(int argc, char** argv) {
    using namespace sph::shocks;
    report::Chapter chapter{"04_artificial_viscosity",
                            "What lets SPH pass a shock, and what does that cost elsewhere?",
                            source_revision};
    chapter.figure("x-t", "the waves of Sod's tube, and where its particles go", x_t)
        .figure("sod-without", "Sod's tube without viscosity", sod_without)
        .figure("sod-viscous", "the same with a viscosity", sod_viscous)
        .figure("cold-streams", "cold streams that meet at Mach 1e4: alpha alone, and beta", cold_streams)
        .figure("contact", "the spike of pressure at a contact, and conduction", contact)
        .timed_figure("sod", "Sod's tube by every method, beside a grid", sod)
        .timed_figure("mach", "a tube with a shock at Mach 1.526, few particles", mach)
        .timed_figure("blast", "a blast with a pressure ratio of 3e10", blast)
        .figure("viscous-pressures", "the viscous pressures of 1950 and 1983, and the viscosity of pairs",
                viscous_pressures)
        .figure("kernels", "the viscosity of 1983 with the Gaussian and the super-Gaussian kernel", kernels)
        .figure("one-at-a-time", "viscosity, kernel and conduction, each with and without the others",
                one_at_a_time)
        .figure("wave", "a standing sound wave: what dissipation costs where there is no shock", wave)
        .figure("noh", "Noh's problem on a line: the wall that heats", noh)
        .figure("review-tube", "figures 15 and 16 of the review, in their own set-up", review_tube)
        .figure("expansion", "the 123 problem and the expansion into a vacuum", expansion)
        .timed_figure("woodward-colella", "two blast waves that meet between walls", woodward_colella)
        .figure("survival",
                "which methods finish the hard cases and are right, on even and on disordered particles",
                SurvivalFigure{})
        .timed_figure("noh-plane", "Noh's problem in the plane", noh_plane)
        .timed_figure("sedov", "a point blast in the plane", sedov)
        .timed_figure("shear-layer", "a shear layer, which artificial viscosity should leave alone",
                      shear_layer)
        .timed_figure("viscous", "real viscosity: a decaying shear wave and Taylor-Green vortices", viscous)
        .figure("layers", "two layers of different viscosity between moving walls", layers)
        .timed_figure("cost", "error against CPU time, beside a grid", cost)
        .timed_figure("cost-of-effects", "what each listed effect adds to the cost of a pair",
                      cost_of_effects)
        .scene("tube", "two states of your choice, against the exact solution", TubeCommand{});
    return chapter.main(argc, argv);
}
