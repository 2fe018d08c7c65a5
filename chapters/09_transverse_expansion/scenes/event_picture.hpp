#pragma once
#include "chapters/09_transverse_expansion/scenes/event.hpp"
#include "common/plot/animation.hpp"

namespace sph::transverse {

/// The temperature of an event's particles, frame by frame, on axes and colours that stand still.
plot::Animation event_animation(const std::string& name, const EventRun& event);

}  // namespace sph::transverse
