#include "chapters/09_transverse_expansion/scenes/event_picture.hpp"

#include <cmath>

#include "common/report/text.hpp"

namespace sph::transverse {

plot::Animation event_animation(const std::string& name, const EventRun& event) {
    constexpr double frame_seconds = 0.15, last_seconds = 1.5;
    double reach = 0;
    for (std::size_t i = 0; i < event.frames.back().x.size(); ++i)
        reach = std::max({reach, std::abs(event.frames.back().x[i]), std::abs(event.frames.back().y[i])});
    double hottest = 0;
    for (const double T : event.frames.front().temperature) hottest = std::max(hottest, T);
    plot::Animation animation{name};
    for (std::size_t k = 0; k < event.frames.size(); ++k) {
        const EventFrame& frame = event.frames[k];
        plot::Figure figure{name};
        figure.panel_width = 420, figure.panel_height = 340;
        plot::Panel& panel = figure.panel();
        panel.labels("$x$", "$y$")
            .titled("τ = " + report::fixed(frame.time, 1))
            .x_range(-reach, reach)
            .y_range(-reach, reach);
        panel.equal_aspect = true;
        plot::Discs discs{"particles", frame.x, frame.y, frame.temperature, 2.5, 0, {}};
        discs.bar = {"$T$/$T$_{0}", plot::Map::magma, std::array{0.05, hottest}, plot::Scale::log, true};
        panel.particles(discs);
        animation.add(figure, k + 1 == event.frames.size() ? last_seconds : frame_seconds);
    }
    return animation;
}

}  // namespace sph::transverse
