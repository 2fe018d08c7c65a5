// Chapter 6. The finite particle method: what do corrected estimates buy on Burgers' equation, with still and
// with moving particles? Figures: renders/06_finite_particle_method/. Text: README.md.
#include "chapters/06_finite_particle_method/scenes/commands.hpp"
#include "revision.hpp"

int main(int argc, char** argv) {
    using namespace sph::fpm;
    report::Chapter chapter{"06_finite_particle_method",
                            "What do CSPM, FPM and SFPM buy on Burgers' equation, with still and with moving "
                            "particles?",
                            source_revision};
    chapter.scene("burgers", "Burgers' equation with your viscosity, method and ends", BurgersCommand{})
        .scene("estimate", "a function with your particles by one member of the family", EstimateCommand{});
    return chapter.main(argc, argv);
}
