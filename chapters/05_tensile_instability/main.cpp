// Chapter 5. Tensile instability: why do particles clump under tension, can it be predicted, what cures it?
// Figures: renders/05_tensile_instability/. Text: README.md.
#include "chapters/05_tensile_instability/scenes/lattice_growth.hpp"
#include "revision.hpp"

int main(int argc, char** argv) {
    using namespace sph::tensile;
    report::Chapter chapter{"05_tensile_instability",
                            "Why do particles clump under tension, can it be predicted, what cures it?",
                            source_revision};
    chapter.scene("lattice-growth",
                  "CSV of the fastest growth for your kernel, h and pressure, on standard output",
                  LatticeGrowthCommand{});
    return chapter.main(argc, argv);
}
