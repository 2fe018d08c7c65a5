#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/plot/extent.hpp"
#include "common/plot/figure.hpp"
#include "common/plot/layout.hpp"
#include "common/plot/ranges.hpp"
#include "common/plot/sizes.hpp"

namespace plot {
namespace {

constexpr double largest_value = 1e300;  // beyond, ranges with margins are no longer finite

/// Collects what is wrong, each line beginning with where.
class Faults {
  public:
    void in(std::string where) { where_ = std::move(where); }
    void add(const std::string& what) { lines_.push_back(where_.empty() ? what : where_ + ": " + what); }
    bool require(bool good, const std::string& what) {
        if (!good) add(what);
        return good;
    }
    std::size_t count() const { return lines_.size(); }
    std::vector<std::string> take() { return std::move(lines_); }

    bool length(const char* name, const Values& values, std::size_t expected) {
        return require(values.size() == expected,
                       fmt::format("{} has {} values instead of {}", name, values.size(), expected));
    }
    void finite(const char* name, const Values& values) {
        const auto bad = std::find_if(values.begin(), values.end(),
                                      [](double v) { return !(std::abs(v) <= largest_value); });
        if (bad != values.end())
            add(fmt::format("{}[{}] = {} is not finite", name, bad - values.begin(), *bad));
    }
    /// Finite and, on a log scale, positive.
    void shown(const char* name, const Values& values, Scale scale) {
        finite(name, values);
        if (scale == Scale::linear) return;
        const auto bad = std::find_if(values.begin(), values.end(), [](double v) { return v <= 0; });
        if (bad != values.end())
            add(fmt::format("{}[{}] = {} is not positive on a log scale", name, bad - values.begin(), *bad));
    }
    void range(const char* name, const std::optional<std::array<double, 2>>& range, Scale scale) {
        if (!range) return;
        const auto [low, high] = *range;
        shown(name, {low, high}, scale);
        const double least = 10 * narrowest_range * std::max(std::abs(low), std::abs(high));
        if (!(high > low))
            add(fmt::format("{} {}..{} is reversed or empty", name, low, high));
        else if (high - low < least)
            add(fmt::format("{} {}..{} is too narrow to be told apart", name, low, high));
    }

  private:
    std::string where_;
    std::vector<std::string> lines_;
};

std::string named(const char* kind, std::size_t index, const std::string& label) {
    return label.empty() ? fmt::format("{} {}", kind, index + 1) : fmt::format("{} \"{}\"", kind, label);
}

void check(Faults& faults, const Panel& panel, const Curve& curve) {
    faults.require(!curve.x.empty(), "no points");
    faults.length("y", curve.y, curve.x.size());
    if (!curve.error.empty()) faults.length("error", curve.error, curve.x.size());
    faults.shown("x", curve.x, panel.x.scale);
    faults.shown("y", curve.y, panel.y.scale);
    faults.finite("error", curve.error);
    faults.require(std::none_of(curve.error.begin(), curve.error.end(), [](double e) { return e < 0; }),
                   "error is negative");
    faults.require(curve.style.width >= 0 && curve.style.marker_size > 0, "width or marker size is negative");
    faults.require(curve.style.width > 0 || curve.style.marker != Marker::none, "neither line nor markers");
}

void check(Faults& faults, const Panel& panel, const Band& band) {
    faults.require(band.x.size() >= 2, "fewer than two points");
    faults.length("low", band.low, band.x.size());
    faults.length("high", band.high, band.x.size());
    faults.shown("x", band.x, panel.x.scale);
    faults.shown("low", band.low, panel.y.scale);
    faults.shown("high", band.high, panel.y.scale);
}

void check(Faults& faults, const Panel& panel, const Discs& discs) {
    faults.require(!discs.x.empty(), "no discs");
    faults.length("y", discs.y, discs.x.size());
    faults.length("value", discs.value, discs.x.size());
    faults.shown("x", discs.x, panel.x.scale);
    faults.shown("y", discs.y, panel.y.scale);
    faults.shown("value", discs.value, discs.bar.scale);
    faults.range("colour range", discs.bar.range, discs.bar.scale);
    faults.require(discs.diameter > 0 || discs.data_diameter > 0, "diameter is not positive");
    faults.require(discs.data_diameter <= 0 || panel.x.scale == Scale::linear,
                   "a diameter in units of x needs a linear axis");
}

void check(Faults& faults, const Panel& panel, const Field& field) {
    const auto increasing = [](const Values& v) {
        return std::is_sorted(v.begin(), v.end(), [](double a, double b) { return a <= b; });
    };
    faults.require(field.x.size() >= 2 && field.y.size() >= 2, "the grid needs two points each way");
    faults.length("value", field.value, field.x.size() * field.y.size());
    faults.shown("x", field.x, panel.x.scale);
    faults.shown("y", field.y, panel.y.scale);
    faults.shown("value", field.value, field.bar.scale);
    faults.shown("contours", field.contours, field.bar.scale);
    faults.range("colour range", field.bar.range, field.bar.scale);
    faults.require(increasing(field.x) && increasing(field.y), "x and y must increase");
}

void check(Faults& faults, const Panel& panel, const Arrows& arrows) {
    faults.require(!arrows.x.empty(), "no arrows");
    faults.length("y", arrows.y, arrows.x.size());
    faults.length("u", arrows.u, arrows.x.size());
    faults.length("v", arrows.v, arrows.x.size());
    faults.shown("x", arrows.x, panel.x.scale);
    faults.shown("y", arrows.y, panel.y.scale);
    faults.finite("u", arrows.u);
    faults.finite("v", arrows.v);
    faults.finite("scale", {arrows.scale});
    faults.require(panel.x.scale == Scale::linear && panel.y.scale == Scale::linear,
                   "arrows need linear axes");
}

void check(Faults& faults, const Panel& panel, const Note& note) {
    faults.shown("x", {note.x}, note.relative ? Scale::linear : panel.x.scale);
    faults.shown("y", {note.y}, note.relative ? Scale::linear : panel.y.scale);
    faults.require(!note.text.empty() && note.size > 0, "no text");
    if (!note.points_at) return;
    faults.shown("points_at x", {(*note.points_at)[0]}, panel.x.scale);
    faults.shown("points_at y", {(*note.points_at)[1]}, panel.y.scale);
}

void check(Faults& faults, const Panel& panel, const ReferenceSlope& slope) {
    faults.require(panel.x.scale == Scale::log && panel.y.scale == Scale::log, "needs a log-log panel");
    faults.shown("x0, x1, y0", {slope.x0, slope.x1, slope.y0}, Scale::log);
    faults.finite("order", {slope.order});
    faults.require(slope.x0 != slope.x1, "x0 equals x1");
}

void check(Faults& faults, const char* name, const Axis& axis) {
    faults.range(fmt::format("{} range", name).c_str(), axis.range, axis.scale);
    faults.shown(fmt::format("{} ticks", name).c_str(), axis.ticks, axis.scale);
    faults.require(axis.tick_names.empty() || axis.tick_names.size() == axis.ticks.size(),
                   fmt::format("{} axis has {} tick names for {} ticks", name, axis.tick_names.size(),
                               axis.ticks.size()));
}

template <class Items, class Name>
void check_each(Faults& faults, const std::string& where, const Panel& panel, const Items& items,
                const char* kind, Name name) {
    for (std::size_t k = 0; k < items.size(); ++k) {
        faults.in(where + named(kind, k, name(items[k])));
        check(faults, panel, items[k]);
    }
}

void check_items(Faults& faults, const std::string& where, const Panel& panel) {
    const auto name = [](const auto& item) { return item.name; };
    const auto label = [](const auto& item) { return item.label; };
    check_each(faults, where, panel, panel.curves, "curve", [](const Curve& c) { return c.style.label; });
    check_each(faults, where, panel, panel.bands, "band", label);
    check_each(faults, where, panel, panel.discs, "discs", name);
    check_each(faults, where, panel, panel.fields, "field", name);
    check_each(faults, where, panel, panel.arrows, "arrows", name);
    check_each(faults, where, panel, panel.notes, "note", [](const Note& n) { return n.text; });
    check_each(faults, where, panel, panel.slopes, "slope", label);
}

void check_axes(Faults& faults, const std::string& where, const Panel& panel) {
    faults.in(where.substr(0, where.empty() ? 0 : where.size() - 2));
    check(faults, "x", panel.x);
    check(faults, "y", panel.y);
    faults.require(panel.legend.columns >= 1, "the legend has no columns");
    faults.require(!panel.equal_aspect || (panel.x.scale == Scale::linear && panel.y.scale == Scale::linear),
                   "equal_aspect needs linear axes");
}

/// Of data without other faults: something must be seen, and every note.
void check_visible(Faults& faults, const std::string& where, const Panel& panel, const PanelRanges& ranges) {
    const auto inside = [&ranges](double x, double y) {
        return ranges.x.contains(x) && ranges.y.contains(y);
    };
    faults.in(where.substr(0, where.empty() ? 0 : where.size() - 2));
    bool seen = false;
    for_each_point(panel, [&](const DataPoint& point) { seen = seen || inside(point.x, point.y); });
    const bool covered = std::any_of(panel.fields.begin(), panel.fields.end(), [&](const Field& field) {
        return field.x.front() <= ranges.x.high && field.x.back() >= ranges.x.low &&
               field.y.front() <= ranges.y.high && field.y.back() >= ranges.y.low;
    });
    const bool noted =
        std::any_of(panel.notes.begin(), panel.notes.end(), [](const Note& n) { return n.relative; });
    faults.require(seen || covered || noted, "no data inside the axes");
    for (const auto& note : panel.notes)
        faults.require(note.relative ? Range{0, 1}.contains(note.x) && Range{0, 1}.contains(note.y)
                                     : inside(note.x, note.y),
                       fmt::format("note \"{}\" lies outside the axes", note.text));
}

void check_figure(Faults& faults, const Figure& figure) {
    const bool plain = std::all_of(figure.name.begin(), figure.name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    });
    faults.require(plain && !figure.name.empty(),
                   "name \"" + figure.name + "\" must consist of lower-case letters, digits, '-' and '_'");
    faults.require(figure.rows >= 1 && figure.columns >= 1 &&
                       figure.panels.size() ==
                           static_cast<std::size_t>(figure.rows) * static_cast<std::size_t>(figure.columns),
                   fmt::format("{} panels do not fill {} rows of {}", figure.panels.size(), figure.rows,
                               figure.columns));
    constexpr double most_pixels = 16384, least_points = 100;
    faults.require(figure.panel_width >= least_points && figure.panel_height >= least_points &&
                       figure.columns * figure.panel_width * pixels_per_point <= most_pixels &&
                       figure.rows * figure.panel_height * pixels_per_point <= most_pixels,
                   "panels must be at least 100 points wide and high, the figure at most 8192");
    faults.require(std::any_of(figure.panels.begin(), figure.panels.end(),
                               [](const Panel& panel) { return !is_blank(panel); }),
                   "nothing to draw");
}

}  // namespace

std::vector<std::string> faults(const Figure& figure) {
    Faults found;
    check_figure(found, figure);
    const auto where = [&figure](std::size_t k) {
        return figure.panels.size() > 1 ? "panel " + panel_letter(k) + ": " : std::string{};
    };
    for (std::size_t k = 0; k < figure.panels.size(); ++k) {
        check_items(found, where(k), figure.panels[k]);
        check_axes(found, where(k), figure.panels[k]);
    }
    if (found.count() > 0) return found.take();  // ranges of faulty data mean nothing
    const auto ranges = axis_ranges(figure);
    for (std::size_t k = 0; k < figure.panels.size(); ++k)
        if (!is_blank(figure.panels[k])) check_visible(found, where(k), figure.panels[k], ranges[k]);
    return found.take();
}

}  // namespace plot
