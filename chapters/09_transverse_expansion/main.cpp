// Chapter 9. Transverse expansion with longitudinal scaling: curved coordinates, and a boost-invariant
// cylinder against its characteristics. Figures: renders/09_transverse_expansion/. Text: README.md.
#include "common/report/chapter.hpp"
#include "revision.hpp"

namespace sph::transverse {}  // namespace sph::transverse

int main(int argc, char** argv) {
    report::Chapter chapter{"09_transverse_expansion",
                            "How do curved coordinates enter, and does a boost-invariant cylinder expand as "
                            "the characteristics say?",
                            source_revision};
    return chapter.main(argc, argv);
}
