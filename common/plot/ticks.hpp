#pragma once
#include <string>
#include <vector>

#include "common/plot/ranges.hpp"
#include "common/plot/text_box.hpp"

namespace plot {

struct Tick {
    double value = 0;
    std::string label;
};
struct Ticks {
    std::vector<Tick> major;
    Values minor;
    std::string factor;  ///< stands at the end of the axis: "×10^{−3}", "×10^{−3} + 1000000"; may be empty
};

/// Ticks at multiples of 1, 2, 2.5 or 5 times a power of ten, at most `most` intervals (>= 1): the finest
/// that satisfies this. All labels have the same number of decimals; numbers that are very large or very
/// small have a common factor, and those that differ only in late digits a common offset.
Ticks linear_ticks(const Range& range, int most);

/// Ticks at powers of ten, thinned to at most `most` intervals; at 1, 2, 5 (or finer) times a power of ten
/// where the range holds fewer than two powers; as on a linear axis where it is narrower still. 0 < low <
/// high.
Ticks log_ticks(const Range& range, int most);

/// The axis' own tick values that lie in the range, with their names or the shortest labels that tell them
/// apart.
Ticks given_ticks(const Axis& axis, const Range& range);

enum class Direction { horizontal, vertical };

/// As many ticks as read well on `map`, thinned until no two labels touch. `text_size`: pixels per em.
Ticks fitting_ticks(const Axis& axis, const AxisMap& map, Direction direction, double text_size,
                    const Measure& measure);

}  // namespace plot
