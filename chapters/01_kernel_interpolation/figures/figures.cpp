#include "chapters/01_kernel_interpolation/figures/figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "chapters/01_kernel_interpolation/kernels.hpp"
#include "common/plot/looks.hpp"
#include "common/plot/method_looks.hpp"

namespace sph::interpolation {

std::string kernel_label(std::string_view name) {
    static const std::map<std::string_view, std::string> labels{
        {"gaussian", "Gaussian"},       {"super-gaussian", "super-Gaussian"}, {"cubic", "cubic spline"},
        {"quartic", "quartic spline"},  {"quintic", "quintic spline"},        {"lucy", "Lucy"},
        {"wendland-c2", "Wendland C2"}, {"wendland-c4", "Wendland C4"},       {"wendland-c6", "Wendland C6"}};
    const auto found = labels.find(name);
    return found == labels.end() ? std::string{name} : found->second;
}

plot::Style kernel_style(std::size_t index, const std::string& label, bool markers) {
    using plot::Dash;
    using plot::Marker;
    constexpr std::array dashes{Dash::solid,       Dash::solid,       Dash::solid,
                                Dash::dash_dotted, Dash::dashed,      Dash::dotted,
                                Dash::dashed,      Dash::dash_dotted, Dash::solid};
    constexpr std::array shapes{Marker::circle,  Marker::triangle_up,   Marker::square,
                                Marker::diamond, Marker::triangle_down, Marker::plus,
                                Marker::diamond, Marker::circle,        Marker::square};
    plot::Style style{.label = label, .colour = plot::cycle(index), .dash = dashes.at(index)};
    if (index >= 8) style.colour = plot::Colour{0.45, 0.45, 0.45};  // the cycle would begin anew
    if (markers) {
        style.marker = shapes.at(index);
        style.filled = index < 5;
        style.dash = Dash::solid;
        style.width = 1;
    }
    return style;
}

bool is_told(std::string_view name) {
    constexpr std::array<std::string_view, 5> told{"gaussian", "super-gaussian", "cubic", "quintic",
                                                   "wendland-c2"};
    return std::find(told.begin(), told.end(), name) != told.end();
}

plot::Style told_style(std::size_t index, const std::string& label, bool markers) {
    const auto names = kernel_names();
    if (is_told(names.at(index))) return kernel_style(index, label, markers);
    const auto first = std::find_if_not(names.begin(), names.end(), is_told);
    return plot::rest(names.begin() + static_cast<std::ptrdiff_t>(index) == first ? "other kernels" : "");
}

plot::Style spot(plot::Colour colour, std::string label, double size) {
    return {.label = std::move(label), .colour = colour, .marker = plot::Marker::circle, .marker_size = size};
}

void draw_support(plot::Panel& panel, const Columns<2>& x, std::size_t centre, double reach, bool named) {
    plot::Values near_x, near_y, far_x, far_y, circle_x, circle_y;
    for (std::size_t j = 0; j < x[0].size(); ++j) {
        if (j == centre) continue;
        const bool inside = std::hypot(x[0][j] - x[0][centre], x[1][j] - x[1][centre]) < reach;
        (inside ? near_x : far_x).push_back(x[0][j]);
        (inside ? near_y : far_y).push_back(x[1][j]);
    }
    for (const double angle : linear_space(0, 2 * pi, 121)) {
        circle_x.push_back(x[0][centre] + reach * std::cos(angle));
        circle_y.push_back(x[1][centre] + reach * std::sin(angle));
    }
    const auto label = [&](const char* text) { return std::string{named ? text : ""}; };
    panel.points(far_x, far_y, spot({0.6, 0.6, 0.6}, label("others"), 4));
    panel.curve(circle_x, circle_y, {.label = label("support of $i$"), .colour = plot::black, .width = 1});
    panel.points(near_x, near_y, spot(plot::cycle(0), label("neighbours $j$"), 5));
    panel.points({x[0][centre]}, {x[1][centre]}, spot(plot::cycle(1), label("particle $i$"), 7));
    panel.labels("$x$", "$y$").equal_aspect = true;
    panel.grid = false;
}

plot::Values linear_space(double low, double high, std::size_t count) {
    plot::Values values(count);
    for (std::size_t i = 0; i < count; ++i) {
        values[i] = low + (high - low) * static_cast<double>(i) / static_cast<double>(count - 1);
    }
    return values;
}

plot::Values log_space(double low, double high, std::size_t count) {
    plot::Values values = linear_space(std::log(low), std::log(high), count);
    for (double& v : values) v = std::exp(v);
    return values;
}

}  // namespace sph::interpolation
