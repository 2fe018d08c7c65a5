// Chapter 9. Transverse expansion with longitudinal scaling: curved coordinates, and a boost-invariant
// cylinder against its characteristics. Figures: renders/09_transverse_expansion/. Text: README.md.
#include "chapters/09_transverse_expansion/scenes/atmosphere.hpp"
#include "chapters/09_transverse_expansion/scenes/line.hpp"
#include "chapters/09_transverse_expansion/scenes/plane_command.hpp"
#include "revision.hpp"

namespace sph::transverse {}  // figures/, each in a file of its name

int main(int argc, char** argv) {
    using namespace sph::transverse;
    report::Chapter chapter{"09_transverse_expansion",
                            "How do curved coordinates enter, and does a boost-invariant cylinder expand as "
                            "the characteristics say?",
                            source_revision};
    chapter.scene("cylinder", "a hot cylinder that expands into the vacuum", CylinderCommand{})
        .scene("gubser", "Gubser's flow", GubserCommand{})
        .scene("line", "the cylinder as rings, in the coordinates (tau, r)", LineCommand{})
        .scene("atmosphere", "a fluid at rest where g_00 varies", AtmosphereCommand{});
    return chapter.main(argc, argv);
}
