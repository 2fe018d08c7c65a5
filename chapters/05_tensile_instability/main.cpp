// Chapter 5. Tensile instability: why do particles clump under tension, can it be predicted, what cures it?
// Figures: renders/05_tensile_instability/. Text: README.md.
#include "chapters/05_tensile_instability/scenes/cure.hpp"
#include "chapters/05_tensile_instability/scenes/elastic_disc.hpp"
#include "chapters/05_tensile_instability/scenes/lattice_growth.hpp"
#include "chapters/05_tensile_instability/scenes/wheel.hpp"
#include "revision.hpp"

namespace sph::tensile {  // figures/, each in a file of its name
void box(report::Run& run);
void bar(report::Run& run);
void criterion(report::Run& run);
void growth_map(report::Run& run);
void modes(report::Run& run);
void pairing(report::Run& run);
void regularisation(report::Run& run);
void cures(report::Run& run);
void cured_particles(report::Run& run);
void balanced_strength(report::Run& run);
void cure_cost(report::Run& run);
void cost_of_effects(report::Run& run);
void solid_cost(report::Run& run);
void elastic_waves(report::Run& run);
void wheel(report::Run& run);
void plate(report::Run& run);
void rings(report::Run& run);
void elastic_disc(report::Run& run);
}  // namespace sph::tensile

int main(int argc, char** argv) {
    using namespace sph::tensile;
    report::Chapter chapter{"05_tensile_instability",
                            "Why do particles clump under tension, can it be predicted, what cures it?",
                            source_revision};
    chapter.figure("box", "a box of particles under tension and under pressure, pushed at one of them", box)
        .figure("bar", "a bar under tension, struck in its middle: SPH, CSPM and the exact answer", bar)
        .figure("growth-map", "growth over all wave vectors: tension, tension along one axis, pressure",
                growth_map)
        .figure("criterion", "Swegle's sign criterion beside the dispersion relation", criterion)
        .figure("modes", "single waves: the predicted and the measured growth or frequency", modes)
        .figure("pairing", "growth under pressure: pairing, Wendland's kernels against splines", pairing)
        .figure("regularisation", "disorder under pressure: does it decay, and how fast?", regularisation)
        .figure("cures", "nineteen ways to treat tension on one scale", cures)
        .figure("cured-particles", "particles under tension at the end, by four methods", cured_particles)
        .figure("balanced-strength", "how strong a balanced background pressure must be", balanced_strength)
        .timed_figure("cure-cost", "what order under tension costs", cure_cost)
        .figure("elastic-waves", "P and S waves in a solid: error against N", elastic_waves)
        .timed_figure("solid-cost", "what the accuracy of elastic waves costs, beside a grid", solid_cost)
        .figure("wheel", "a rotating elastic wheel and its angular momentum", wheel)
        .figure("plate", "a clamped plate that swings, and one that carries a load", plate)
        .figure("rings", "two rubber rings collide, with and without artificial stress", rings)
        .figure("elastic-disc", "does a relaxed disc with a radial velocity stay whole?", elastic_disc)
        .timed_figure("cost-of-effects", "what each listed effect costs", cost_of_effects)
        .scene("lattice-growth",
               "CSV of the fastest growth for your kernel, h and pressure, on standard output",
               LatticeGrowthCommand{})
        .scene("cure", "disordered particles under tension, by any cure", CureCommand{})
        .scene("wheel", "a rotating elastic wheel with your method, size and speed", WheelCommand{})
        .scene("elastic-disc", "an elastic disc, thrown outwards, with your method and speed",
               ElasticDiscCommand{});
    return chapter.main(argc, argv);
}
