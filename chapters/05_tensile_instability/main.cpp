// Chapter 5. Tensile instability: why do particles clump under tension, can it be predicted, what cures it?
// Figures: renders/05_tensile_instability/. Text: README.md.
#include "chapters/05_tensile_instability/scenes/lattice_growth.hpp"
#include "revision.hpp"

namespace sph::tensile {  // figures/, each in a file of its name
void box(report::Run& run);
void bar(report::Run& run);
void criterion(report::Run& run);
void growth_map(report::Run& run);
void modes(report::Run& run);
void pairing(report::Run& run);
void regularisation(report::Run& run);
}  // namespace sph::tensile

int main(int argc, char** argv) {
    using namespace sph::tensile;
    report::Chapter chapter{"05_tensile_instability",
                            "Why do particles clump under tension, can it be predicted, what cures it?",
                            source_revision};
    chapter.figure("box", "a box of particles under tension and under pressure, pushed at one of them", box)
        .figure("bar", "a bar under tension, struck in its middle: SPH, CSPM and the exact answer", bar)
        .figure("criterion", "Swegle's sign criterion beside the dispersion relation", criterion)
        .figure("growth-map", "growth over all wave vectors: tension, tension along one axis, pressure",
                growth_map)
        .figure("modes", "single waves: the predicted and the measured growth or frequency", modes)
        .figure("pairing", "growth under pressure: pairing, Wendland's kernels against splines", pairing)
        .figure("regularisation", "disorder under pressure: does it decay, and how fast?", regularisation)
        .scene("lattice-growth",
               "CSV of the fastest growth for your kernel, h and pressure, on standard output",
               LatticeGrowthCommand{});
    return chapter.main(argc, argv);
}
