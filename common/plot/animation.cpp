#include "common/plot/animation.hpp"

#include <fmt/format.h>

#include <utility>

namespace plot {

Animation::Animation(std::string animation_name, std::string shared_title)
    : name{std::move(animation_name)}, title{std::move(shared_title)} {}

Animation& Animation::add(Figure figure, double seconds) {
    frames.push_back({std::move(figure), seconds});
    return *this;
}

Figure Animation::shown(std::size_t k) const {
    Figure figure = frames.at(k).figure;
    figure.name = name;
    if (figure.title.empty()) figure.title = title;
    return figure;
}

std::vector<std::string> faults(const Animation& animation) {
    const std::size_t count = animation.frames.size();
    if (count < 1 || count > most_frames)
        return {fmt::format("an animation has 1 to {} frames, not {}", most_frames, count)};
    std::vector<std::string> lines;
    for (std::size_t k = 0; k < count; ++k) {
        const double seconds = animation.frames[k].seconds;
        if (!(seconds >= shortest_frame && seconds <= longest_frame))
            lines.push_back(fmt::format("frame {} is shown for {} s, which must be in {}..{} s", k + 1,
                                        seconds, shortest_frame, longest_frame));
        for (const std::string& fault : faults(animation.shown(k)))
            lines.push_back(fmt::format("frame {}: {}", k + 1, fault));
    }
    return lines;
}

}  // namespace plot
