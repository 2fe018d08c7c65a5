#include "common/plot/legend.hpp"

#include <algorithm>
#include <cmath>

#include "common/plot/sizes.hpp"

namespace plot {
namespace {

// In ems of the legend's text.
constexpr double padding = 0.55;
constexpr double row_height = 1.45;
constexpr double sample_width = 2.3;
constexpr double sample_gap = 0.7;
constexpr double column_gap = 1.4;

std::vector<LegendItem> labelled(const Panel& panel) {
    std::vector<LegendItem> items;
    if (!panel.legend.shown) return items;
    const auto lines = curve_colours(panel);
    for (std::size_t k = 0; k < panel.curves.size(); ++k)
        if (const Style& style = panel.curves[k].style; !style.label.empty())
            items.push_back({style, lines[k], false, {}, {}});
    const auto areas = band_colours(panel);
    for (std::size_t k = 0; k < panel.bands.size(); ++k)
        if (const auto& label = panel.bands[k].label; !label.empty()) {
            items.push_back({{}, areas[k], true, {}, {}});
            items.back().style.label = label;
        }
    return items;
}

void move_by(TextBox& text, Point by) {
    text.anchor = {text.anchor.x + by.x, text.anchor.y + by.y};
    text.box = {text.box.left + by.x, text.box.top + by.y, text.box.right + by.x, text.box.bottom + by.y};
}

Rect moved(const Rect& rect, Point by) {
    return {rect.left + by.x, rect.top + by.y, rect.right + by.x, rect.bottom + by.y};
}

constexpr double clearance = 8;  // from the frame, pixels

/// The usual places, the best first: corners, then the middles of the sides.
std::vector<Point> usual_places(const Rect& area, const Rect& box) {
    const double left = area.left + clearance, right = area.right - clearance - box.width();
    const double top = area.top + clearance, bottom = area.bottom - clearance - box.height();
    const double centre = (left + right) / 2, middle = (top + bottom) / 2;
    return {{right, top},   {left, top},   {left, bottom},   {right, bottom}, {right, middle},
            {left, middle}, {centre, top}, {centre, bottom}, {centre, middle}};
}

struct Candidate {
    Point at;
    double covered = 1;
    double distance = 0;  // to the nearest usual place, pixels
};

double cover_at(const Occupancy& occupancy, const Rect& box, Point at) {
    return occupancy.covered(grown(moved(box, at), 4));
}

Candidate best_place(const Occupancy& occupancy, const Rect& box) {
    const auto places = usual_places(occupancy.area(), box);
    Candidate best;
    for (const Point at : places) {
        const double covered = cover_at(occupancy, box, at);
        if (covered < best.covered) best = {at, covered, 0};
        if (best.covered == 0) return best;
    }
    constexpr double step = 8;
    const Point first = places[1], last = places[3];
    for (double y = first.y; y <= last.y; y += step)
        for (double x = first.x; x <= last.x; x += step) {
            double distance = 1e9;
            for (const Point at : places) distance = std::min(distance, std::hypot(at.x - x, at.y - y));
            const Candidate here{{x, y}, cover_at(occupancy, box, {x, y}), distance};
            if (std::pair{here.covered, here.distance} < std::pair{best.covered, best.distance}) best = here;
        }
    return best;
}

}  // namespace

std::vector<Colour> curve_colours(const Panel& panel) {
    std::vector<Colour> colours;
    std::size_t next = 0;
    for (const auto& curve : panel.curves)
        colours.push_back(curve.style.colour ? *curve.style.colour : cycle(next++));
    return colours;
}

std::vector<Colour> band_colours(const Panel& panel) {
    auto next = static_cast<std::size_t>(
        std::count_if(panel.curves.begin(), panel.curves.end(),
                      [](const Curve& curve) { return !curve.style.colour.has_value(); }));
    std::vector<Colour> colours;
    for (const auto& band : panel.bands) {
        colours.push_back(band.colour ? *band.colour : cycle(next++));
        if (!band.colour) colours.back().alpha = 0.25;
    }
    return colours;
}

LegendLayout legend_at_origin(const Panel& panel, double text_size, int columns, const Measure& measure) {
    LegendLayout legend;
    legend.items = labelled(panel);
    if (legend.items.empty()) return legend;
    const TextStyle text{.size = text_size, .colour = ink};
    const double em = text_size;
    double top = padding * em, width = 0;
    if (!panel.legend.title.empty()) {
        legend.title.push_back(text_box({padding * em, top + 0.95 * em}, panel.legend.title, text, measure));
        width = legend.title[0].box.right;
        top += row_height * em;
    }
    const auto rows =
        (legend.items.size() + static_cast<std::size_t>(columns) - 1) / static_cast<std::size_t>(columns);
    double left = padding * em, column_right = 0;
    for (std::size_t k = 0; k < legend.items.size(); ++k) {
        if (k > 0 && k % rows == 0) left = column_right + column_gap * em;
        LegendItem& item = legend.items[k];
        const double middle = top + (static_cast<double>(k % rows) + 0.5) * row_height * em;
        item.sample = {left, middle - 0.35 * em, left + sample_width * em, middle + 0.35 * em};
        item.text = text_box({item.sample.right + sample_gap * em, middle + cap_height / 2 * em},
                             item.style.label, text, measure);
        column_right = std::max(column_right, item.text.box.right);
    }
    width = std::max(width, column_right) + padding * em;
    legend.box = {0, 0, width, top + static_cast<double>(rows) * row_height * em + padding * em};
    return legend;
}

LegendLayout moved(LegendLayout legend, Point by) {
    legend.box = moved(legend.box, by);
    for (auto& title : legend.title) move_by(title, by);
    for (auto& item : legend.items) {
        item.sample = moved(item.sample, by);
        move_by(item.text, by);
    }
    return legend;
}

LegendPlace place_legend(const Panel& panel, const Occupancy& occupancy, const Measure& measure) {
    struct Shape {
        int columns;
        double text_size;
    };
    const int columns = std::max(1, panel.legend.columns);
    const Shape shapes[] = {{columns, legend_text},
                            {columns + 1, legend_text},
                            {columns, 0.88 * legend_text},
                            {columns + 1, 0.88 * legend_text}};
    LegendPlace best{{}, no_place};
    for (const auto& shape : shapes) {
        const LegendLayout legend = legend_at_origin(panel, shape.text_size, shape.columns, measure);
        if (legend.items.empty()) return {{}, 0};
        if (shape.columns > columns && legend.items.size() < 4) continue;
        const Rect& area = occupancy.area();
        const bool fits = legend.box.width() + 2 * clearance <= area.width() &&
                          legend.box.height() + 2 * clearance <= area.height();
        if (!fits) continue;
        const Candidate place = best_place(occupancy, legend.box);
        if (place.covered < best.covered) best = {moved(legend, place.at), place.covered};
        if (best.covered == 0) break;
    }
    return best;
}

}  // namespace plot
