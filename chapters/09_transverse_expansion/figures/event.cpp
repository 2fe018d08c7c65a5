#include <cmath>

#include "chapters/09_transverse_expansion/scenes/event_picture.hpp"
#include "common/plot/looks.hpp"

namespace sph::transverse {

/// One event as a film.
void event(report::Run& run) {
    EventScene scene{.n = run.quick() ? 800UL : 2500UL, .times = {}};
    const int frames = run.quick() ? 4 : 15;
    for (int k = 0; k < frames; ++k) scene.times.push_back(1 + 7.0 * k / (frames - 1));
    const EventRun one = run_event(scene);
    run.save(event_animation("event", one));
    run.record("spiral-graded", one.frames.back().x.size(),
               {{"eps_2", one.eccentricity[0]},
                {"eps_3", one.eccentricity[1]},
                {"v_2", one.flow[0]},
                {"v_3", one.flow[1]},
                {"momentum_drift", one.momentum}});
}

}  // namespace sph::transverse
