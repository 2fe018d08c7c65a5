#pragma once
#include <vector>

#include "common/plot/canvas.hpp"
#include "common/plot/polyline.hpp"

namespace plot {

/// What the data of a panel covers, on a coarse grid of pixels: where a legend or a label may stand.
class Occupancy {
  public:
    explicit Occupancy(const Rect& area);

    void add(const LineSegment& segment);
    void add(const Polyline& line);
    void add(const Rect& rect, double weight = 1);
    /// Curves with their markers and error bars, bands (lightly), discs, arrows and contour lines of a panel;
    /// filled fields do not count, they are everywhere.
    void add(const Panel& panel, const AxisMap& x_map, const AxisMap& y_map);

    /// Fraction of the rectangle that is covered, 0..1, by weight. What lies outside the area counts as
    /// covered.
    double covered(const Rect& rect) const;
    Rect area() const noexcept { return area_; }

  private:
    static constexpr double cell_ = 4;  // pixels

    int column(double x) const;
    int row(double y) const;
    void mark(int column, int row, double weight);
    void add_curve(const Curve& curve, const AxisMap& x_map, const AxisMap& y_map);
    void add_band(const Band& band, const AxisMap& x_map, const AxisMap& y_map);

    Rect area_;
    std::size_t place(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }
    int columns_ = 0, rows_ = 0;
    std::vector<float> weights_;  // row by row
};

}  // namespace plot
