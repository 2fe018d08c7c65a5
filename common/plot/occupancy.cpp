#include "common/plot/occupancy.hpp"

#include <algorithm>
#include <cmath>

#include "common/plot/contour.hpp"
#include "common/plot/sizes.hpp"
#include "common/plot/text_box.hpp"

namespace plot {

Occupancy::Occupancy(const Rect& area)
    : area_{area},
      columns_{std::max(1, static_cast<int>(std::ceil(area.width() / cell_)))},
      rows_{std::max(1, static_cast<int>(std::ceil(area.height() / cell_)))},
      weights_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

int Occupancy::column(double x) const {
    return static_cast<int>(std::floor((x - area_.left) / cell_));
}
int Occupancy::row(double y) const {
    return static_cast<int>(std::floor((y - area_.top) / cell_));
}

void Occupancy::mark(int column, int row, double weight) {
    if (column < 0 || column >= columns_ || row < 0 || row >= rows_) return;
    float& cell = weights_[place(row, column)];
    cell = std::max(cell, static_cast<float>(weight));
}

void Occupancy::add(const LineSegment& segment) {
    const auto part = clipped(segment, area_);
    if (!part) return;
    const double dx = part->to.x - part->from.x, dy = part->to.y - part->from.y;
    const int steps = std::max(1, static_cast<int>(std::ceil(std::hypot(dx, dy) / (cell_ / 2))));
    for (int k = 0; k <= steps; ++k) {
        const double t = static_cast<double>(k) / steps;
        mark(column(part->from.x + t * dx), row(part->from.y + t * dy), 1);
    }
}

void Occupancy::add(const Polyline& line) {
    for (std::size_t i = 1; i < line.size(); ++i) add(LineSegment{line[i - 1], line[i]});
}

void Occupancy::add(const Rect& rect, double weight) {
    if (!overlap(rect, area_)) return;
    for (int r = std::max(0, row(rect.top)); r <= std::min(rows_ - 1, row(rect.bottom)); ++r)
        for (int c = std::max(0, column(rect.left)); c <= std::min(columns_ - 1, column(rect.right)); ++c)
            mark(c, r, weight);
}

void Occupancy::add_curve(const Curve& curve, const AxisMap& x_map, const AxisMap& y_map) {
    const Polyline line = pixels(curve.x, curve.y, x_map, y_map);
    if (curve.style.width > 0) add(thinned(line));
    if (curve.style.marker != Marker::none)
        for (const auto& [x, y] : line)
            add(grown(Rect{x, y, x, y}, curve.style.marker_size * pixels_per_point / 2));
    for (std::size_t i = 0; i < curve.error.size(); ++i) {
        const bool reaches_zero = y_map.scale == Scale::log && curve.error[i] >= curve.y[i];
        const double low = reaches_zero ? y_map.range.low : curve.y[i] - curve.error[i];
        add(LineSegment{pixel(curve.x[i], low, x_map, y_map),
                        pixel(curve.x[i], curve.y[i] + curve.error[i], x_map, y_map)});
    }
}

void Occupancy::add_band(const Band& band, const AxisMap& x_map, const AxisMap& y_map) {
    constexpr double weight = 0.3;  // a legend over a band hides less than one over a line
    for (std::size_t i = 1; i < band.x.size(); ++i) {
        const Point low0 = pixel(band.x[i - 1], band.low[i - 1], x_map, y_map);
        const Point low1 = pixel(band.x[i], band.low[i], x_map, y_map);
        const Point high0 = pixel(band.x[i - 1], band.high[i - 1], x_map, y_map);
        const Point high1 = pixel(band.x[i], band.high[i], x_map, y_map);
        const double first = std::max(std::min(low0.x, low1.x), area_.left);
        const double last = std::min(std::max(low0.x, low1.x), area_.right);
        for (double x = first; x <= last; x += cell_) {
            const double t = low1.x == low0.x ? 0.0 : (x - low0.x) / (low1.x - low0.x);
            const double low = low0.y + t * (low1.y - low0.y), high = high0.y + t * (high1.y - high0.y);
            add(Rect{x, std::min(low, high), x, std::max(low, high)}, weight);
        }
    }
}

void Occupancy::add(const Panel& panel, const AxisMap& x_map, const AxisMap& y_map) {
    for (const auto& curve : panel.curves) add_curve(curve, x_map, y_map);
    for (const auto& band : panel.bands) add_band(band, x_map, y_map);
    for (const auto& discs : panel.discs) {
        const double diameter = disc_pixels(discs, x_map);
        for (std::size_t i = 0; i < discs.x.size(); ++i) {
            const Point centre = pixel(discs.x[i], discs.y[i], x_map, y_map);
            add(grown(Rect{centre.x, centre.y, centre.x, centre.y}, diameter / 2));
        }
    }
    for (const auto& arrows : panel.arrows)
        for (std::size_t i = 0; i < arrows.x.size(); ++i)
            add(LineSegment{pixel(arrows.x[i], arrows.y[i], x_map, y_map),
                            pixel(arrows.x[i] + arrows.scale * arrows.u[i],
                                  arrows.y[i] + arrows.scale * arrows.v[i], x_map, y_map)});
    for (const auto& field : panel.fields)
        for (const double level : field.contours)
            for (auto& line : contour_lines(field, level)) {
                for (auto& at : line) at = pixel(at.x, at.y, x_map, y_map);
                add(line);
            }
}

double Occupancy::covered(const Rect& rect) const {
    const int left = column(rect.left), right = column(rect.right);
    const int top = row(rect.top), bottom = row(rect.bottom);
    double sum = 0;
    for (int r = top; r <= bottom; ++r)
        for (int c = left; c <= right; ++c) {
            const bool outside = c < 0 || c >= columns_ || r < 0 || r >= rows_;
            sum += outside ? 1.0 : static_cast<double>(weights_[place(r, c)]);
        }
    return sum / (static_cast<double>(right - left + 1) * static_cast<double>(bottom - top + 1));
}

}  // namespace plot
