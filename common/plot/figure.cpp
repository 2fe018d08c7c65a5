#include "common/plot/figure.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace plot {

Panel& Panel::titled(std::string text) {
    title = std::move(text);
    return *this;
}

Panel& Panel::labels(std::string x_label, std::string y_label) {
    x.label = std::move(x_label);
    y.label = std::move(y_label);
    return *this;
}

Panel& Panel::log_x() {
    x.scale = Scale::log;
    return *this;
}

Panel& Panel::log_y() {
    y.scale = Scale::log;
    return *this;
}

Panel& Panel::log_log() {
    return log_x().log_y();
}

Panel& Panel::x_range(double low, double high) {
    x.range = {low, high};
    return *this;
}

Panel& Panel::y_range(double low, double high) {
    y.range = {low, high};
    return *this;
}

Curve& Panel::curve(Values x_values, Values y_values, Style style) {
    return curves.emplace_back(Curve{std::move(x_values), std::move(y_values), {}, std::move(style)});
}

Curve& Panel::points(Values x_values, Values y_values, Style style) {
    style.width = 0;
    if (style.marker == Marker::none) style.marker = Marker::circle;
    return curve(std::move(x_values), std::move(y_values), std::move(style));
}

Band& Panel::band(Values x_values, Values low, Values high, std::string label) {
    return bands.emplace_back(
        Band{std::move(x_values), std::move(low), std::move(high), std::move(label), {}});
}

Discs& Panel::particles(Discs added) {
    return discs.emplace_back(std::move(added));
}

Panel& Panel::bars(const std::vector<std::string>& names, const Values& values) {
    constexpr double half = 0.3;
    if (names.size() != values.size()) throw std::invalid_argument{"bars: as many names as values"};
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double at = static_cast<double>(values.size() - k);
        y.ticks.push_back(at);
        y.tick_names.push_back(names[k]);
        band({0, values[k]}, {at - half, at - half}, {at + half, at + half}).colour = cycle(0);
    }
    if (!x.range && !values.empty())
        x.range = std::array{0.0, 1.1 * *std::max_element(values.begin(), values.end())};
    grid = false;
    return *this;
}

Field& Panel::field(Field added) {
    return fields.emplace_back(std::move(added));
}

Arrows& Panel::vectors(Arrows added) {
    return arrows.emplace_back(std::move(added));
}

Note& Panel::note(double x_position, double y_position, std::string text) {
    Note& added = notes.emplace_back();
    added.x = x_position;
    added.y = y_position;
    added.text = std::move(text);
    return added;
}

ReferenceSlope& Panel::slope(double order, double x0, double x1, double y0, std::string label) {
    return slopes.emplace_back(ReferenceSlope{x0, y0, x1, order, std::move(label)});
}

Figure::Figure(std::string figure_name, int row_count, int column_count)
    : name{std::move(figure_name)}, rows{row_count}, columns{column_count} {
    if (rows < 1 || columns < 1)
        throw std::invalid_argument{"a figure needs at least one row and one column"};
    panels.resize(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns));
}

Panel& Figure::at(int row, int column) {
    if (row < 0 || row >= rows || column < 0 || column >= columns)
        throw std::out_of_range{"figure " + name + " has no panel in row " + std::to_string(row) +
                                ", column " + std::to_string(column)};
    return panels[static_cast<std::size_t>(row * columns + column)];
}

}  // namespace plot
