// Chapter 5. Tensile instability: why do particles clump under tension, can it be predicted, what cures it?
// Figures: renders/05_tensile_instability/. Text: README.md.
#include "common/report/chapter.hpp"
#include "revision.hpp"

int main(int argc, char** argv) {
    report::Chapter chapter{"05_tensile_instability",
                            "Why do particles clump under tension, can it be predicted, what cures it?",
                            source_revision};
    return chapter.main(argc, argv);
}
