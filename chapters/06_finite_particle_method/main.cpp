// Chapter 6. The finite particle method: what do corrected estimates buy on Burgers' equation, with still and
// with moving particles? Figures: renders/06_finite_particle_method/. Text: README.md.
#include "chapters/06_finite_particle_method/scenes/commands.hpp"
#include "revision.hpp"

namespace sph::fpm {  // figures/, each in a file of its name
void x_t(report::Run& run);
void two_gaussians_figure(report::Run& run);
void two_gaussians_end(report::Run& run);
void orders(report::Run& run);
void singular(report::Run& run);
void still(report::Run& run);
void profiles(report::Run& run);
void moving_ends(report::Run& run);
void crossing(report::Run& run);
void remedies(report::Run& run);
void cost(report::Run& run);
void cost_of_estimates(report::Run& run);
}  // namespace sph::fpm

int main(int argc, char** argv) {
    using namespace sph::fpm;
    report::Chapter chapter{"06_finite_particle_method",
                            "What do CSPM, FPM and SFPM buy on Burgers' equation, with still and with moving "
                            "particles?",
                            source_revision};
    chapter.figure("x-t", "the world lines of the fluid, and how close they come", x_t)
        .figure("two-gaussians", "two Gaussians by SPH and by FPM, even and random", two_gaussians_figure)
        .figure("orders", "errors of value, slope and curvature against N", orders)
        .figure("singular", "random neighbourhoods that do not determine a fit", singular)
        .timed_figure("still", "Burgers' equation on still particles, by all methods", still)
        .figure("profiles", "still particles at three viscosities", profiles)
        .figure("moving-ends", "moving particles with frozen, free and mirrored ends", moving_ends)
        .figure("crossing", "particles that meet, and pass through each other", crossing)
        .figure("remedies", "remeshing, and particles that move to where they are needed", remedies)
        .figure("two-gaussians-end", "the same, near the right end", two_gaussians_end)
        .timed_figure("cost", "error against CPU time, beside differences", cost)
        .timed_figure("cost-of-estimates", "what each estimate costs a particle", cost_of_estimates)
        .scene("burgers", "Burgers' equation with your viscosity, method and ends", BurgersCommand{})
        .scene("estimate", "a function with your particles by one member of the family", EstimateCommand{});
    return chapter.main(argc, argv);
}
