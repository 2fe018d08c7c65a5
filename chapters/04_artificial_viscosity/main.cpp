// Chapter 4. Artificial viscosity: what lets SPH pass a shock, and what does that cost elsewhere?
// Figures: renders/04_artificial_viscosity/. Text: README.md.
#include "chapters/04_artificial_viscosity/figures/figures.hpp"
#include "revision.hpp"

int main(int argc, char** argv) {
    using namespace sph::shocks;
    using report::Run;
    report::Chapter chapter{"04_artificial_viscosity",
                            "What lets SPH pass a shock, and what does that cost elsewhere?",
                            source_revision};
    Options options;
    options.declare(chapter.options());

    chapter.figure("sod", "Sod's tube by every method, beside a grid", sod)
        .figure("mach", "a tube with a shock at Mach 1.526, few particles", mach)
        .figure("blast", "a blast with a pressure ratio of 3e10", blast)
        .figure("viscous-pressures", "the viscous pressures of 1950 and 1983, and the viscosity of pairs",
                viscous_pressures)
        .figure("kernels", "the viscosity of 1983 with the Gaussian and the super-Gaussian kernel", kernels)
        .figure("wave", "a standing sound wave: what dissipation costs where there is no shock", wave)
        .figure("colliding", "cold streams that meet at Mach 1e4, and Noh's problem", colliding)
        .figure("expansion", "the 123 problem and the expansion into a vacuum", expansion)
        .figure("woodward-colella", "two blast waves that meet between walls", woodward_colella)
        .figure("survival", "which methods finish the hard cases, on even and on disordered particles",
                [&](Run& run) { survival(run, options.all_runs); })
        .figure("noh-plane", "Noh's problem in the plane", noh_plane)
        .figure("sedov", "a point blast in the plane", sedov)
        .figure("shear-layer", "a shear layer, which artificial viscosity should leave alone", shear_layer)
        .figure("viscous", "real viscosity: a decaying shear wave and Taylor-Green vortices", viscous)
        .figure("cost", "error against CPU time, beside a grid", cost)
        .figure("cost-of-effects", "what each listed effect adds to the cost of a pair", cost_of_effects)
        .scene("tube", "two states of your choice, against the exact solution",
               [&](Run& run) { tube_scene(run, options); });
    return chapter.main(argc, argv);
}
