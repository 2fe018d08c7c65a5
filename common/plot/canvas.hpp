#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/plot/figure.hpp"

/// What can be drawn, in pixels: the layer between figures and OpenGL. The origin is the top left corner, y
/// grows downwards, pixel centres lie at half-integers.
namespace plot {

struct Point {
    double x = 0, y = 0;
};
struct Rect {
    double left = 0, top = 0, right = 0, bottom = 0;
    double width() const noexcept { return right - left; }
    double height() const noexcept { return bottom - top; }
};
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  ///< row by row from the top, 3 bytes a pixel
};
using Polyline = std::vector<Point>;

/// Extent of a line of text around its anchor on the baseline. Height is at least that of "lp", so that
/// labels without tall or deep letters have it too.
struct TextSize {
    double width = 0, ascent = 0, descent = 0;  ///< ascent and descent are both >= 0
};
/// Which part of the text lies at the anchor; middle: half the height of a capital letter or digit, as looks
/// right beside a tick.
enum class Vertical { top, middle, baseline, bottom };
struct TextStyle {
    double size = 20;  ///< pixels per em
    Colour colour{};
    Anchor horizontal = Anchor::left;
    Vertical vertical = Vertical::baseline;
    double angle = 0;  ///< degrees, counter-clockwise around the anchor
};
struct MarkerStyle {
    Marker shape = Marker::circle;
    /// Of a circle the diameter; squares, diamonds and triangles have the same area, so that they weigh the
    /// same. Plus and cross have arms of 1.2 sizes, in the edge's colour and width.
    double size = 10;
    Colour fill{}, edge{};
    double edge_width = 1;  ///< centred on the outline
    bool filled = true;     ///< open markers show what lies below
};

/// An off-screen picture. One canvas serves many pictures: its context and shaders are made once.
class Canvas {
  public:
    /// Throws app::IoError naming what is missing (font file, OpenGL) and its Debian package.
    Canvas();
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    /// A new white picture. Throws std::invalid_argument unless it has 1..16384 pixels each way.
    /// Drawing without a picture throws std::logic_error.
    void begin(int width, int height);
    Image finish();  ///< the picture so far

    void clip(const Rect& rect);  ///< nothing outside is drawn until unclip(); snapped to whole pixels
    void unclip();

    /// Lines with round joins and caps, composited as one stroke: where they overlap, a translucent colour
    /// does not add up. A point that is not finite leaves a gap; a point alone is a dot.
    /// `dashes`: lengths of drawn and left-out pieces in pixels, caps included, empty for solid. Throws
    /// std::invalid_argument if they are not pairs of lengths >= 0.
    void stroke(std::span<const Polyline> lines, double width, Colour colour,
                std::span<const double> dashes = {});
    /// One horizontal or vertical line, snapped to whole pixels: sharp edges, flat ends, 1 pixel or wider.
    void rule(Point from, Point to, double width, Colour colour);
    void rectangle(const Rect& rect, Colour colour);  ///< filled, snapped to whole pixels
    /// Filled triangles, anti-aliased (4x4 supersampling); three corners each, a colour a corner. No seams
    /// between triangles of one call that share an edge. Throws std::invalid_argument if the numbers differ.
    void triangles(std::span<const Point> corners, std::span<const Colour> colours);
    void markers(std::span<const Point> centres, const MarkerStyle& style);
    /// Filled discs, a colour each. Throws std::invalid_argument if the numbers differ.
    void discs(std::span<const Point> centres, double diameter, std::span<const Colour> colours);

    /// UTF-8 with the markup of figure.hpp: `_{..}`, `^{..}`, `$italic$`; what is not UTF-8 is drawn as
    /// U+FFFD. `size`: pixels per em. Throws std::invalid_argument unless it is > 0 and at most 2048.
    TextSize measure(std::string_view text, double size) const;
    void text(Point anchor, std::string_view text, const TextStyle& style);

    /// "OSMesa, 4.5 core, Mesa 22.3.6, llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string renderer() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

}  // namespace plot
