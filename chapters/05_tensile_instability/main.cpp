// Chapter 5. Tensile instability: why do particles clump under tension, can it be predicted, what cures it?
// Figures: renders/05_tensile_instability/. Text: README.md.
#include "chapters/05_tensile_instability/scenes/cure.hpp"
#include "common/report/chapter.hpp"
#include "revision.hpp"

namespace sph::tensile {  // figures/, each in a file of its name
void cures(report::Run& run);
void cured_particles(report::Run& run);
void balanced_strength(report::Run& run);
void cure_cost(report::Run& run);
}  // namespace sph::tensile

int main(int argc, char** argv) {
    report::Chapter chapter{"05_tensile_instability",
                            "Why do particles clump under tension, can it be predicted, what cures it?",
                            source_revision};
    using namespace sph::tensile;
    chapter.figure("cures", "fifteen ways to treat tension on one scale", cures)
        .figure("cured-particles", "particles under tension at the end, by four methods", cured_particles)
        .figure("balanced-strength", "how strong a balanced background pressure must be", balanced_strength)
        .timed_figure("cure-cost", "what order under tension costs", cure_cost)
        .scene("cure", "disordered particles under tension, by any cure", CureCommand{});
    return chapter.main(argc, argv);
}
