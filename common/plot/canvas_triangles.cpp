#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/plot/canvas_implementation.hpp"

namespace plot {
namespace {

constexpr int magnification = 4;
constexpr int tile_side = 256;  // pixels; magnified it is 4 MB, which stays in the processor's cache

/// Triangles sorted into square tiles that cover `box`: those that touch it, in their order.
class Tiles {
  public:
    explicit Tiles(const PixelBox& box)
        : box_{box},
          columns_{(box.width() + tile_side - 1) / tile_side},
          rows_{(box.height() + tile_side - 1) / tile_side},
          indices_(static_cast<std::size_t>(columns_ * rows_)) {}

    void add(unsigned first_vertex, const Rect& bounds) {
        const auto tile = [](double from_edge, int count) {
            return static_cast<int>(std::clamp(std::floor(from_edge / tile_side), -1.0, double(count)));
        };
        const int left = std::max(tile(bounds.left - box_.left, columns_), 0);
        const int right = std::min(tile(bounds.right - box_.left, columns_), columns_ - 1);
        const int top = std::max(tile(bounds.top - box_.top, rows_), 0);
        const int bottom = std::min(tile(bounds.bottom - box_.top, rows_), rows_ - 1);
        for (int row = top; row <= bottom; ++row)
            for (int column = left; column <= right; ++column) {
                auto& list = indices_[static_cast<std::size_t>(row * columns_ + column)];
                list.insert(list.end(), {first_vertex, first_vertex + 1, first_vertex + 2});
            }
    }

    template <class Draw>
    void for_each(Draw draw) const {
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < columns_; ++column) {
                const auto& list = indices_[static_cast<std::size_t>(row * columns_ + column)];
                const int left = box_.left + column * tile_side, top = box_.top + row * tile_side;
                const PixelBox part{left, top, std::min(left + tile_side, box_.right),
                                    std::min(top + tile_side, box_.bottom)};
                if (!list.empty()) draw(part, list);
            }
    }

  private:
    PixelBox box_;
    int columns_, rows_;
    std::vector<std::vector<unsigned>> indices_;
};

/// NaN or infinite where a corner is.
Rect bounds(std::span<const Point> corners) {
    Rect box{corners[0].x, corners[0].y, corners[0].x, corners[0].y};
    for (const Point& p : corners) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) return {NAN, NAN, NAN, NAN};
        box = {std::min(box.left, p.x), std::min(box.top, p.y), std::max(box.right, p.x),
               std::max(box.bottom, p.y)};
    }
    return box;
}

}  // namespace

void Canvas::triangles(std::span<const Point> corners, std::span<const Colour> colours) {
    if (corners.size() != colours.size() || corners.size() % 3 != 0)
        throw std::invalid_argument{"triangles need three corners each, and a colour a corner"};
    Implementation& self = *self_;
    self.prepare();
    std::vector<ColouredPoint> vertices;
    std::vector<Rect> boxes;
    vertices.reserve(corners.size());
    boxes.reserve(corners.size() / 3);
    Rect all = self.visible();
    std::swap(all.left, all.right);
    std::swap(all.top, all.bottom);
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        const Rect box = bounds(corners.subspan(i, 3));
        if (std::isnan(box.left)) continue;
        boxes.push_back(box);
        all = {std::min(all.left, box.left), std::min(all.top, box.top), std::max(all.right, box.right),
               std::max(all.bottom, box.bottom)};
        for (std::size_t k = i; k < i + 3; ++k)
            vertices.push_back(
                {static_cast<float>(corners[k].x), static_cast<float>(corners[k].y), bytes(colours[k])});
    }
    const PixelBox area = common_part(self.clip, covering_pixels(all));
    if (boxes.empty() || area.empty()) return;

    Tiles tiles{area};
    for (std::size_t i = 0; i < boxes.size(); ++i) tiles.add(static_cast<unsigned>(3 * i), boxes[i]);
    constexpr int texels = tile_side * magnification;
    if (!self.tile) self.tile.emplace(texels, texels, Surface::Format::colour);
    self.coloured_vertices.load(vertices.data(), vertices.size());
    const bool opaque = std::all_of(vertices.begin(), vertices.end(),
                                    [](const ColouredPoint& vertex) { return vertex.colour[3] == 255; });
    tiles.for_each([&self, opaque](const PixelBox& part, const std::vector<unsigned>& indices) {
        self.tile->draw_here();
        glScissor(0, 0, texels, texels);
        glClearColor(0, 0, 0, 0);
        glClear(GL_COLOR_BUFFER_BIT);
        if (opaque) glDisable(GL_BLEND);  // saves reading what is there
        self.programs.triangles.use(texels, texels);
        self.programs.triangles.set("tile_origin", static_cast<float>(part.left),
                                    static_cast<float>(part.top));
        self.programs.triangles.set("magnification", static_cast<float>(magnification));
        self.coloured_vertices.draw_triangles(indices.data(), indices.size());
        glEnable(GL_BLEND);
        self.draw_tile(part);
    });
}

void Canvas::Implementation::draw_tile(const PixelBox& box) {
    tile->read_here();
    draw_into_picture(programs.resolve, box);
    programs.resolve.set("tile_origin", static_cast<float>(box.left), static_cast<float>(box.top));
    programs.resolve.set("tile_texels", static_cast<float>(tile->width()));
    draw_boxes({&box, 1});
}

}  // namespace plot
