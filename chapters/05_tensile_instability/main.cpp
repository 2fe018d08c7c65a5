// Chapter 5. Tensile instability: why do particles clump under tension, can it be predicted, what cures it?
// Figures: renders/05_tensile_instability/. Text: README.md.
#include "chapters/05_tensile_instability/scenes/elastic_disc.hpp"
#include "chapters/05_tensile_instability/scenes/wheel.hpp"
#include "revision.hpp"

namespace sph::tensile {  // figures/, each in a file of its name
void elastic_waves(report::Run& run);
void plate(report::Run& run);
void rings(report::Run& run);
void wheel(report::Run& run);
void elastic_disc(report::Run& run);
}  // namespace sph::tensile

int main(int argc, char** argv) {
    using namespace sph::tensile;
    report::Chapter chapter{"05_tensile_instability",
                            "Why do particles clump under tension, can it be predicted, what cures it?",
                            source_revision};
    chapter.figure("elastic-waves", "P and S waves in a solid: error against N", elastic_waves)
        .figure("plate", "a clamped plate that swings, and one that carries a load", plate)
        .figure("rings", "two rubber rings collide, with and without artificial stress", rings)
        .figure("wheel", "a rotating elastic wheel and its angular momentum", wheel)
        .figure("elastic-disc", "does a relaxed disc with a radial velocity stay whole?", elastic_disc)
        .scene("wheel", "a rotating elastic wheel with your method, size and speed", WheelCommand{})
        .scene("elastic-disc", "an elastic disc, thrown outwards, with your method and speed",
               ElasticDiscCommand{});
    return chapter.main(argc, argv);
}
