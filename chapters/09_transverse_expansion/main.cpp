// Chapter 9. Transverse expansion with longitudinal scaling: curved coordinates, and a boost-invariant
// cylinder against its characteristics. Figures: renders/09_transverse_expansion/. Text: README.md.
#include "chapters/09_transverse_expansion/scenes/atmosphere.hpp"
#include "chapters/09_transverse_expansion/scenes/event.hpp"
#include "chapters/09_transverse_expansion/scenes/line.hpp"
#include "chapters/09_transverse_expansion/scenes/plane_command.hpp"
#include "revision.hpp"

namespace sph::transverse {  // figures/, each in a file of its name
void maps(report::Run& run);
void bjorken(report::Run& run);
void cylinder_profiles(report::Run& run);
void places(report::Run& run);
void methods(report::Run& run);
void gubser_profiles(report::Run& run);
void order(report::Run& run);
void rings(report::Run& run);
void atmosphere(report::Run& run);
void hard_cases(report::Run& run);
void freeze_out(report::Run& run);
void plateau(report::Run& run);
void event(report::Run& run);
void flow(report::Run& run);
void cost(report::Run& run);
void cost_of_effects(report::Run& run);
}  // namespace sph::transverse

int main(int argc, char** argv) {
    using namespace sph::transverse;
    report::Chapter chapter{"09_transverse_expansion",
                            "How do curved coordinates enter, and does a boost-invariant cylinder expand as "
                            "the characteristics say?",
                            source_revision};
    chapter.figure("maps", "the cylinder's particles at three times", maps)
        .figure("bjorken", "Bjorken's flow, at rest and drifting", bjorken)
        .figure("cylinder", "temperature against radius at four times", cylinder_profiles)
        .figure("places", "where particles begin", places)
        .figure("methods", "what places, smoothing lengths and forces do to the error", methods)
        .timed_figure("gubser", "Gubser's flow", gubser_profiles)
        .figure("order", "the error of the time step", order)
        .figure("rings", "the cylinder as rings, where sqrt(-g) has a gradient", rings)
        .figure("atmosphere", "a fluid at rest where g_00 has one", atmosphere)
        .figure("hard-cases", "the vacuum's edge, and a start at small tau0", hard_cases)
        .figure("freeze-out", "what the rarefaction has reached, and the freeze-out radius", freeze_out)
        .figure("plateau", "three dimensions, seen at eta = 0", plateau)
        .figure("event", "an event of hot spots, as a film", event)
        .figure("flow", "the shape at the start against the flow at the end", flow)
        .timed_figure("cost", "error of the cylinder against CPU time, beside a grid", cost)
        .timed_figure("cost-of-effects", "what each listed effect costs", cost_of_effects)
        .scene("cylinder", "a hot cylinder that expands into the vacuum", CylinderCommand{})
        .scene("gubser", "Gubser's flow", GubserCommand{})
        .scene("event", "hot spots at random places", EventCommand{})
        .scene("line", "the cylinder as rings, in the coordinates (tau, r)", LineCommand{})
        .scene("atmosphere", "a fluid at rest where g_00 varies", AtmosphereCommand{});
    return chapter.main(argc, argv);
}
