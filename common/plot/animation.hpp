#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "common/plot/figure.hpp"

namespace plot {

inline constexpr std::size_t most_frames = 60;
inline constexpr double shortest_frame = 0.02;  // s; browsers show shorter ones longer
inline constexpr double longest_frame = 10;     // s

/// Figures shown one after the other, again and again. All must have one size; so that axes and colours stand
/// still, give them ranges, and put legends outside: what is chosen by default follows the data of each
/// frame. One frame alone is a still picture.
struct Animation {
    struct Frame {
        Figure figure;         ///< its name is not used
        double seconds = 0.1;  ///< how long it is shown, in 0.02..10 s; stored in whole milliseconds
    };

    std::string name;           ///< file name without extension, as a figure's
    std::string title;          ///< above each frame whose own is empty; may be empty
    std::vector<Frame> frames;  ///< 1 to 60

    explicit Animation(std::string animation_name, std::string shared_title = {});
    Animation& add(Figure figure, double seconds = 0.1);
    /// Frame k as it is drawn: with the animation's name, and its title if it has none.
    Figure shown(std::size_t k) const;
};

/// What is wrong with an animation, one line a fault: the number of frames, how long they are shown, faults
/// of their figures. Empty: nothing; whether the frames have one size is known when they are drawn.
std::vector<std::string> faults(const Animation& animation);

}  // namespace plot
