#include "common/plot/canvas_stroke.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plot {
namespace {

bool finite(const Point& point) {
    return std::isfinite(point.x) && std::isfinite(point.y);
}

/// Drawn intervals along a line, repeated with a period.
struct DashPattern {
    struct Interval {
        double from, to;
    };
    std::vector<Interval> drawn;
    double period = 0;
};

// Round caps add half the width at each end; the drawn pieces are shortened by as much, so that the gaps
// stay.
DashPattern dash_pattern(std::span<const double> dashes, double width) {
    DashPattern pattern;
    const bool valid =
        std::all_of(dashes.begin(), dashes.end(), [](double d) { return std::isfinite(d) && d >= 0; });
    if (!valid || dashes.size() % 2 != 0)
        throw std::invalid_argument{"dashes must be pairs of lengths >= 0 of drawn and left-out pieces"};
    for (std::size_t i = 0; i < dashes.size(); i += 2) {
        const double cap = std::min(0.5 * width, 0.5 * dashes[i]);
        pattern.drawn.push_back({pattern.period + cap, pattern.period + dashes[i] - cap});
        pattern.period += dashes[i] + dashes[i + 1];
    }
    if (pattern.period < 0.1 && !dashes.empty())
        throw std::invalid_argument{"dashes must be at least 0.1 pixels long altogether"};
    return pattern;
}

/// The part [from, to] of 0..1 of the way from `a` to `b` that lies in `box` (Liang and Barsky's method);
/// empty if from > to.
DashPattern::Interval clip(const Point& a, const Point& b, const Rect& box) {
    DashPattern::Interval part{0, 1};
    const auto cut = [&part](double step, double room) {  // keeps t step <= room
        if (step == 0) {
            if (room < 0) part = {1, 0};
        } else if (step > 0) {
            part.to = std::min(part.to, room / step);
        } else {
            part.from = std::max(part.from, room / step);
        }
    };
    cut(a.x - b.x, a.x - box.left);
    cut(b.x - a.x, box.right - a.x);
    cut(a.y - b.y, a.y - box.top);
    cut(b.y - a.y, box.bottom - a.y);
    return part;
}

class Stroker {
  public:
    Stroker(double width, std::span<const double> dashes, const Rect& visible)
        : pattern_{dash_pattern(dashes, width)} {
        const double reach = 0.5 * width + 1;
        box_ = {visible.left - reach, visible.top - reach, visible.right + reach, visible.bottom + reach};
    }

    void add(const Polyline& line) {
        double travelled = 0;
        for (std::size_t i = 0; i < line.size(); ++i) {
            if (!finite(line[i])) continue;
            const bool follows = i > 0 && finite(line[i - 1]);
            const bool leads = i + 1 < line.size() && finite(line[i + 1]);
            if (leads) {
                piece(line[i], line[i + 1], travelled);
                travelled += std::hypot(line[i + 1].x - line[i].x, line[i + 1].y - line[i].y);
            } else if (!follows) {
                piece(line[i], line[i], travelled);
            }
        }
    }

    std::vector<Segment> take() { return std::move(segments_); }

  private:
    void piece(const Point& a, const Point& b, double start) {
        const auto part = clip(a, b, box_);
        if (part.from > part.to) return;
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        if (pattern_.period == 0 || length == 0) return push(a, b, part.from, part.to);
        const double begin = start + part.from * length, end = start + part.to * length;
        for (double origin = std::floor(begin / pattern_.period) * pattern_.period; origin <= end;
             origin += pattern_.period)
            for (const auto& drawn : pattern_.drawn) {
                const double from = std::max(begin, origin + drawn.from);
                const double to = std::min(end, origin + drawn.to);
                if (from <= to) push(a, b, (from - start) / length, (to - start) / length);
            }
    }

    void push(const Point& a, const Point& b, double from, double to) {
        const auto at = [&](double t) { return Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; };
        const Point first = from == 0 ? a : at(from), last = to == 1 ? b : at(to);
        segments_.push_back({static_cast<float>(first.x), static_cast<float>(first.y),
                             static_cast<float>(last.x), static_cast<float>(last.y)});
    }

    DashPattern pattern_;
    Rect box_;
    std::vector<Segment> segments_;
};

/// Square cells over an area, each touched or not.
class CellGrid {
  public:
    static constexpr int side = 32;

    explicit CellGrid(const PixelBox& area)
        : area_{area},
          columns_{(area.width() + side - 1) / side},
          rows_{(area.height() + side - 1) / side},
          touched_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

    void mark(const Rect& rect) {
        const PixelBox part = common_part(covering_pixels(rect), area_);
        if (part.empty()) return;
        for (int row = (part.top - area_.top) / side; row <= (part.bottom - 1 - area_.top) / side; ++row)
            for (int column = (part.left - area_.left) / side; column <= (part.right - 1 - area_.left) / side;
                 ++column)
                touched_[index(row, column)] = 1;
    }

    /// Touched cells, those side by side as one box.
    std::vector<PixelBox> boxes() const {
        std::vector<PixelBox> result;
        for (int row = 0; row < rows_; ++row)
            for (int column = 0, run = 0; column < columns_; column += run + 1) {
                run = 0;
                while (column + run < columns_ && touched_[index(row, column + run)] != 0) ++run;
                if (run == 0) continue;
                const PixelBox cells{area_.left + column * side, area_.top + row * side,
                                     area_.left + (column + run) * side, area_.top + (row + 1) * side};
                result.push_back(common_part(cells, area_));
            }
        return result;
    }

  private:
    std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }
    PixelBox area_;
    int columns_, rows_;
    std::vector<char> touched_;
};

}  // namespace

std::vector<Segment> stroke_segments(std::span<const Polyline> lines, double width,
                                     std::span<const double> dashes, const Rect& visible) {
    Stroker stroker{width, dashes, visible};
    for (const Polyline& line : lines) stroker.add(line);
    return stroker.take();
}

std::vector<PixelBox> touched_boxes(std::span<const Segment> segments, double reach, const PixelBox& area) {
    if (area.empty()) return {};
    CellGrid grid{area};
    for (const Segment& s : segments) {
        // A long slanting piece is followed in steps of a cell: the box around all of it would be mostly
        // empty.
        const double way_x = s.bx - s.ax, way_y = s.by - s.ay;
        const int steps = 1 + static_cast<int>(std::min(std::abs(way_x), std::abs(way_y)) / CellGrid::side);
        for (int i = 0; i < steps; ++i) {
            const auto [x1, x2] = std::minmax({s.ax + way_x * i / steps, s.ax + way_x * (i + 1) / steps});
            const auto [y1, y2] = std::minmax({s.ay + way_y * i / steps, s.ay + way_y * (i + 1) / steps});
            grid.mark({x1 - reach, y1 - reach, x2 + reach, y2 + reach});
        }
    }
    return grid.boxes();
}

}  // namespace plot
