#pragma once
#include <array>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A figure is a value: panels that hold curves, bands, discs, fields, arrows and notes, with their axes and
/// labels. The same value is drawn, saved as CSV (save.hpp) and checked by tests; nothing is drawn that is
/// not in it. Text everywhere is UTF-8 with a little markup: `_{..}`, `^{..}`, `$italic$`. Titles, axis
/// labels and notes are broken at spaces where they are too long, and at every newline.
namespace plot {

using Values = std::vector<double>;

struct Colour {
    double red = 0, green = 0, blue = 0, alpha = 1;  // each in 0..1, sRGB
};
/// Colour-blind-safe cycle (Okabe-Ito order adapted to white paper); `index` wraps around.
Colour cycle(std::size_t index);

enum class Scale { linear, log };
enum class Marker { none, circle, square, diamond, triangle_up, triangle_down, plus, cross };
enum class Dash { solid, dashed, dotted, dash_dotted };
enum class Map {
    viridis,
    cividis,
    magma,
    blue_red
};  // blue_red diverges: centre it on 0 with ColourBar::range
enum class Anchor { left, centre, right };

/// How a curve looks. Sizes are in points (1/72 inch; a figure's width is given in points too).
struct Style {
    std::string label{};             ///< legend entry; none when empty
    std::optional<Colour> colour{};  ///< default: next of the cycle
    Dash dash = Dash::solid;
    double width = 1.5;  ///< 0: no line
    Marker marker = Marker::none;
    double marker_size = 5;
    bool filled = true;  ///< filled or open markers
    int layer = 1;       ///< higher layers are drawn over lower ones; below 0: behind bands and discs
};

struct Curve {
    Values x{}, y{};
    Values error{};  ///< half length of vertical error bars; empty: none
    Style style{};
};
struct Band {
    Values x{}, low{}, high{};
    std::string label{};
    std::optional<Colour> colour{};  ///< default: next of the cycle, translucent
};

struct ColourBar {
    std::string label{};
    Map map = Map::viridis;
    std::optional<std::array<double, 2>> range{};  ///< default: smallest and largest value
    Scale scale = Scale::linear;
    bool shown = true;
};
/// Particles as filled discs coloured by value (one per particle).
struct Discs {
    std::string name{};
    Values x{}, y{}, value{};
    double diameter = 4;  ///< in points; or, if data_diameter > 0, that is used in units of x
    double data_diameter = 0;
    ColourBar bar{};
};
/// A function on the grid x (columns) by y (rows): value[row * x.size() + column].
struct Field {
    std::string name{};
    Values x{}, y{}, value{};
    bool filled = true;  ///< smooth filled contours
    Values contours{};   ///< levels of contour lines, may be empty
    bool contour_labels = false;
    ColourBar bar{};
};
struct Arrows {
    std::string name{};
    Values x{}, y{}, u{}, v{};  ///< the arrow from (x, y) to (x + scale u, y + scale v)
    double scale = 1;
    Colour colour{0.15, 0.15, 0.15};
    double width = 1.0;
};
/// A short text inside the panel, centred vertically on its position and moved inside where it would be cut.
struct Note {
    double x = 0, y = 0;  ///< data units; if `relative`, fractions of the panel, y upwards
    std::string text{};
    bool relative = false;
    Anchor anchor = Anchor::left;
    double size = 8;
    std::optional<std::array<double, 2>> points_at{};  ///< an arrow from the text to this data point
};
/// A dashed line of slope `order` on a log-log panel through (x0, y0) to x1, labelled ("order 2").
struct ReferenceSlope {
    double x0 = 1, y0 = 1, x1 = 10, order = 1;
    std::string label{};
};

struct Axis {
    std::string label{};
    Scale scale = Scale::linear;
    std::optional<std::array<double, 2>> range{};  ///< default: the data with a small margin
    bool tick_labels = true;
    Values ticks{};                       ///< default: chosen well
    std::vector<std::string> tick_names;  ///< one for each of `ticks`; default: their numbers
};

struct Legend {
    bool shown = true;
    bool outside = false;  ///< to the right of the panel; default: where it covers the least data
    std::string title{};
    int columns = 1;
};

struct Panel {
    std::string title;
    Axis x, y;
    Legend legend;
    bool equal_aspect = false;
    bool grid = true;
    std::deque<Curve> curves;  // deques: references that the builders return stay valid
    std::deque<Band> bands;
    std::deque<Discs> discs;
    std::deque<Field> fields;
    std::deque<Arrows> arrows;
    std::deque<Note> notes;
    std::deque<ReferenceSlope> slopes;

    Panel& titled(std::string text);
    Panel& labels(std::string x_label, std::string y_label);
    Panel& log_x();
    Panel& log_y();
    Panel& log_log();
    Panel& x_range(double low, double high);
    Panel& y_range(double low, double high);

    Curve& curve(Values x_values, Values y_values, Style style = {});
    /// Markers without a line.
    Curve& points(Values x_values, Values y_values, Style style = {});
    Band& band(Values x_values, Values low, Values high, std::string label = {});
    /// Horizontal bars from 0 to the values, named at the left, the first on top.
    Panel& bars(const std::vector<std::string>& names, const Values& values);
    Discs& particles(Discs discs);
    Field& field(Field field);
    Arrows& vectors(Arrows arrows);
    Note& note(double x_position, double y_position, std::string text);
    ReferenceSlope& slope(double order, double x0, double x1, double y0, std::string label = {});
};

/// A grid of panels. Default size: 400 x 300 points a panel, drawn at 2 pixels a point; rows in which all
/// panels have equal_aspect are made lower if they need less.
struct Figure {
    std::string name;   ///< file name without extension: lower-case letters, digits, '-', '_'
    std::string title;  ///< above all panels; may be empty
    int rows = 1, columns = 1;
    double panel_width = 400, panel_height = 300;
    bool share_x = false;       ///< panels of a column have one x range; tick labels only on the lowest
    bool share_y = false;       ///< panels of a row have one y range; tick labels only on the leftmost
    bool letters = true;        ///< (a), (b), ... when there is more than one panel
    std::vector<Panel> panels;  // rows * columns, row by row

    explicit Figure(std::string figure_name, int row_count = 1, int column_count = 1);
    Panel& at(int row, int column);
    Panel& panel() { return panels.front(); }
};

/// What is wrong with a figure's data, one line a fault: lengths that differ, values that are not finite,
/// non-positive values on a log axis, a reversed range, no visible data. Empty: nothing.
std::vector<std::string> faults(const Figure& figure);

}  // namespace plot
