#include "chapters/09_transverse_expansion/scenes/event.hpp"
#include "chapters/09_transverse_expansion/scenes/event_picture.hpp"

namespace sph::transverse {

void EventCommand::declare(app::CommandLine& line) {
    line.integer("spots", spots_, 1, 1000, "hot spots of width 1 in the disc r < 5")
        .integer("particles", particles_, 200, 200000,
                 "of the disc r < 9; where there is next to no matter they are left out")
        .number("time", time_, {1, 100, true}, "length",
                "proper time tau at which the scene ends; it begins at 1");
}

void EventCommand::run(report::Run& run) const {
    constexpr int frames = 20;
    EventScene scene{.spots = spots_,
                     .seed = run.seed(),
                     .n = static_cast<std::size_t>(particles_),
                     .times = {},
                     .threads = run.threads(),
                     .progress = run.progress()};
    for (int k = 0; k < frames; ++k) scene.times.push_back(1 + (time_ - 1) * k / (frames - 1));
    const EventRun event = run_event(scene);
    const EventFrame& last = event.frames.back();
    run.record("spiral-graded", last.x.size(),
               {{"eps_2", event.eccentricity[0]},
                {"eps_3", event.eccentricity[1]},
                {"v_2", event.flow[0]},
                {"v_3", event.flow[1]},
                {"momentum_drift", event.momentum},
                {"steps", static_cast<double>(event.counters.steps)},
                {"cpu_seconds", event.seconds, "s"}});
    run.write("profile.csv", report::csv({{"x", last.x},
                                          {"y", last.y},
                                          {"temperature", last.temperature},
                                          {"u_x", last.u_x},
                                          {"u_y", last.u_y}}));
    run.save(event_animation("event-scene", event));
}

}  // namespace sph::transverse
