// Chapter 3. Euler SPH: how does interpolation become dynamics that conserve momentum and energy?
// Figures: renders/03_euler_sph/. Text: README.md.
#include "chapters/03_euler_sph/figures/figures.hpp"
#include "revision.hpp"

int main(int argc, char** argv) {
    using namespace sph::euler;
    using report::Run;
    report::Chapter chapter{"03_euler_sph",
                            "How does interpolation become dynamics that conserve momentum and energy?",
                            source_revision};
    Options options;
    options.declare(chapter.options());

    chapter.figure("forms", "what each form of the equations conserves", forms)
        .figure("wave", "a standing sound wave: error against N for each rule of h", wave)
        .figure("dispersion", "sound waves of every length: the formula, and simulations", dispersion_figure)
        .figure("reversal", "a wave run forward and back again, by several integrators", reversal)
        .figure("energy", "the energy of a star that oscillates for long", energy)
        .figure("rarefaction", "gas that expands into the vacuum", rarefaction)
        .figure("star-modes", "twenty linear modes of a toy star", star_modes)
        .figure("star-nonlinear", "a toy star that swings to half and to twice its radius", star_nonlinear)
        .figure("disc", "random points that relax to a star in 2D, and what is interpolated on them", disc)
        .figure("necklace", "the circulation around a necklace of tracers", necklace)
        .figure("patch", "a square of liquid, distorted by its own motion", patch)
        .figure("hard-case", "hard cases: a star that walks away, and constant h where density vanishes",
                hard_case)
        .figure("cost", "error against CPU time, beside a Lagrangian grid", cost)
        .figure("cost-of-effects", "what each listed effect adds to the cost of a pair", cost_of_effects)
        .scene("dispersion", "CSV of omega^2 for your kernel, h, gamma and wave numbers, on standard output",
               [&](Run& run) { dispersion_scene(run, options); })
        .scene("wave", "a standing wave with your resolution, kernel, h and N",
               [&](Run& run) { wave_scene(run, options); })
        .scene("star", "a nonlinear toy star with your gamma, amplitude, spacing and resolution",
               [&](Run& run) { star_scene(run, options); })
        .scene("rarefaction", "expansion into the vacuum with your gamma, resolution and N",
               [&](Run& run) { rarefaction_scene(run, options); });
    return chapter.main(argc, argv);
}
