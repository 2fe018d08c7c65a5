// Chapter 3. Euler SPH: how does interpolation become dynamics that conserve momentum and energy?
// Figures: renders/03_euler_sph/. Text: README.md.
#include "chapters/03_euler_sph/scenes/dispersion.hpp"
#include "chapters/03_euler_sph/scenes/rarefaction.hpp"
#include "chapters/03_euler_sph/scenes/star.hpp"
#include "chapters/03_euler_sph/scenes/wave.hpp"
#include "revision.hpp"

namespace sph::euler {  // figures/, each in a file of its name
void walk(report::Run& run);
void forms(report::Run& run);
void omega(report::Run& run);
void wave(report::Run& run);
void dispersion_figure(report::Run& run);
void reversal(report::Run& run);
void energy(report::Run& run);
void orbit(report::Run& run);
void rarefaction(report::Run& run);
void star_modes(report::Run& run);
void star_nonlinear(report::Run& run);
void disc(report::Run& run);
void necklace(report::Run& run);
void patch(report::Run& run);
void hard_case(report::Run& run);
void cost(report::Run& run);
void cost_of_effects(report::Run& run);
}  // namespace sph::euler

int main(int argc, char** argv) {
    using namespace sph::euler;
    report::Chapter chapter{"03_euler_sph",
                            "How does interpolation become dynamics that conserve momentum and energy?",
                            source_revision};
    chapter.figure("walk", "a star that its own forces push away", walk)
        .figure("forms", "what each form of the equations conserves", forms)
        .figure("omega", "the factor of h that follows the density, on a line and in a star", omega)
        .figure("wave", "a standing sound wave: error against N for each rule of h", wave)
        .figure("dispersion", "sound waves of every length: the formula, and simulations", dispersion_figure)
        .figure("reversal", "a wave run forward and back again, by several integrators", reversal)
        .figure("energy", "the energy of a star that oscillates for long", energy)
        .figure("orbit", "an eccentric orbit for long, by leapfrog and by RK4", orbit)
        .figure("rarefaction", "gas that expands into the vacuum", rarefaction)
        .figure("star-modes", "twenty linear modes of a toy star", star_modes)
        .figure("star-nonlinear", "a toy star that swings to half and to twice its radius", star_nonlinear)
        .figure("disc", "random points that relax to a star in 2D, and what is interpolated on them", disc)
        .figure("necklace", "the circulation around a necklace of tracers", necklace)
        .figure("patch", "a square of liquid, distorted by its own motion", patch)
        .figure("hard-case", "hard cases: one h for all where the density vanishes", hard_case)
        .timed_figure("cost", "error against CPU time, beside a Lagrangian grid", cost)
        .timed_figure("cost-of-effects", "what each listed effect adds to the cost of a pair",
                      cost_of_effects)
        .scene("dispersion", "CSV of omega^2 for your kernel, h, gamma and wave numbers, on standard output",
               DispersionCommand{})
        .scene("wave", "a standing wave with your resolution, kernel, h and N", WaveCommand{})
        .scene("star", "a nonlinear toy star with your gamma, amplitude, spacing and resolution",
               StarCommand{})
        .scene("rarefaction", "expansion into the vacuum with your gamma, resolution and N",
               RarefactionCommand{});
    return chapter.main(argc, argv);
}
