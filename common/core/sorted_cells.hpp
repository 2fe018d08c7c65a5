#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <vector>

namespace sph {

template <int d>
using Vector = std::array<double, d>;
/// One column per coordinate: x[axis][particle].
template <int d>
using Columns = std::array<std::vector<double>, d>;

/// Points sorted by the cell of a regular grid, so that the neighbours of any position lie in a few
/// contiguous ranges: one range in 1D, a range per row of cells in 2D and 3D. Ranges are all that a
/// vectorised loop needs; they may hold points beyond the support, which a kernel of compact support
/// multiplies by zero.
template <int d>
class SortedCells {
  public:
    /// `x`: equal columns of finite coordinates; `support` > 0: largest distance of a neighbour, same unit.
    /// Throws std::invalid_argument otherwise. Cost: O(points + cells); the cells are coarsened where the
    /// points are so spread out that there would be more cells than four times the points.
    SortedCells(const Columns<d>& x, double support);

    /// The index in `x` of the k-th point in the sorted order.
    std::span<const std::size_t> order() const noexcept { return order_; }
    /// `column`, given in the caller's order, in the sorted order, followed by `padding` zeros.
    std::vector<double> sorted(const std::vector<double>& column, std::size_t padding = 0) const;

    /// Calls visit(begin, end) with ranges of the sorted order that together hold every point within the
    /// support of `position` once, and some points beyond it.
    template <class Visit>
    void for_each_range(const Vector<d>& position, Visit&& visit) const;

  private:
    // Cells narrower than the support follow the sphere more closely, at the price of more ranges.
    static constexpr int cells_per_support = d == 1 ? 8 : d == 2 ? 2 : 1;

    long cell_of(double coordinate, int axis) const {
        const double cell = std::floor((coordinate - low_[axis]) / width_);
        return static_cast<long>(std::clamp(cell, -1e9, 1e9));
    }
    std::size_t flat(const Vector<d>& position) const;

    Vector<d> low_{};
    std::array<long, d> count_{};
    double width_ = 1;
    std::vector<std::size_t> start_, order_;
};

template <int d>
SortedCells<d>::SortedCells(const Columns<d>& x, double support) : width_{support / cells_per_support} {
    if (!(support > 0) || !std::isfinite(support)) throw std::invalid_argument{"support must be positive"};
    const std::size_t n = x[0].size();
    Vector<d> high{};
    for (std::size_t axis = 0; axis < d; ++axis) {
        if (x[axis].size() != n) throw std::invalid_argument{"columns of different length"};
        for (const double c : x[axis]) {
            if (!std::isfinite(c)) throw std::invalid_argument{"coordinate is not finite"};
        }
        const auto ends = std::minmax_element(x[axis].begin(), x[axis].end());
        low_[axis] = n == 0 ? 0 : *ends.first;
        high[axis] = n == 0 ? 0 : *ends.second;
    }
    const auto cells_at = [&](double width) {
        double cells = 1;
        for (std::size_t axis = 0; axis < d; ++axis)
            cells *= 1 + std::floor((high[axis] - low_[axis]) / width);
        return cells;
    };
    while (cells_at(width_) > 4.0 * static_cast<double>(n) + 64) width_ *= 2;
    std::size_t cells = 1;
    for (std::size_t axis = 0; axis < d; ++axis) {
        count_[axis] = 1 + static_cast<long>(std::floor((high[axis] - low_[axis]) / width_));
        cells *= static_cast<std::size_t>(count_[axis]);
    }
    // Counting sort: stable, so the order of equal cells is the caller's and results do not depend on the
    // machine.
    std::vector<std::size_t> cell(n);
    start_.assign(cells + 1, 0);
    for (std::size_t k = 0; k < n; ++k) {
        Vector<d> position{};
        for (std::size_t axis = 0; axis < d; ++axis) position[axis] = x[axis][k];
        cell[k] = flat(position);
        ++start_[cell[k] + 1];
    }
    for (std::size_t c = 0; c < cells; ++c) start_[c + 1] += start_[c];
    order_.resize(n);
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t k = 0; k < n; ++k) order_[next[cell[k]]++] = k;
}

template <int d>
std::size_t SortedCells<d>::flat(const Vector<d>& position) const {
    std::size_t index = 0;
    for (int axis = d - 1; axis >= 0; --axis) {
        const auto a = static_cast<std::size_t>(axis);
        const long cell = std::clamp(cell_of(position[a], axis), 0L, count_[a] - 1);
        index = index * static_cast<std::size_t>(count_[a]) + static_cast<std::size_t>(cell);
    }
    return index;
}

template <int d>
std::vector<double> SortedCells<d>::sorted(const std::vector<double>& column, std::size_t padding) const {
    std::vector<double> result(order_.size() + padding, 0.0);
    for (std::size_t k = 0; k < order_.size(); ++k) result[k] = column.at(order_[k]);
    return result;
}

template <int d>
template <class Visit>
void SortedCells<d>::for_each_range(const Vector<d>& position, Visit&& visit) const {
    std::array<long, 3> first{0, 0, 0}, last{0, 0, 0};
    for (std::size_t axis = 0; axis < d; ++axis) {
        const long centre = cell_of(position[axis], static_cast<int>(axis));
        first[axis] = std::max(centre - cells_per_support, 0L);
        last[axis] = std::min(centre + cells_per_support, count_[axis] - 1);
        if (first[axis] > last[axis]) return;
    }
    const long rows = d > 1 ? count_[1 % d] : 1;
    for (long k = first[2]; k <= last[2]; ++k) {
        for (long j = first[1]; j <= last[1]; ++j) {
            const long row = (k * rows + j) * count_[0];
            const std::size_t begin = start_[static_cast<std::size_t>(row + first[0])];
            const std::size_t end = start_[static_cast<std::size_t>(row + last[0] + 1)];
            if (begin < end) visit(begin, end);
        }
    }
}

}  // namespace sph
