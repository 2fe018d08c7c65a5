#include "chapters/04_artificial_viscosity/scenes/plane_lattice.hpp"

#include <cmath>
#include <stdexcept>

namespace sph::shocks {

Placed make_lattice(Lattice lattice, const Vector<2>& low, const Vector<2>& high, double per_unit) {
    const double width = high[0] - low[0], height = high[1] - low[1];
    const bool square = lattice == Lattice::square;
    const double stretch = square ? 1 : std::sqrt(std::sqrt(3.0) / 2);  // of the rows, at equal area
    const double columns = std::round(width * per_unit * stretch);
    const double rows =
        square ? std::round(height * per_unit) : 2 * std::round(height * per_unit / stretch / 2);
    Placed placed;
    placed.spacing = std::sqrt(width * height / (columns * rows));
    for (double row = 0; row < rows; ++row) {
        const double shift = square ? 0.5 : std::fmod(row, 2) == 0 ? 0.25 : 0.75;
        for (double column = 0; column < columns; ++column) {
            placed.x[0].push_back(low[0] + (column + shift) * width / columns);
            placed.x[1].push_back(low[1] + (row + 0.5) * height / rows);
        }
    }
    return placed;
}

void require_lattice(Lattice lattice, bool quarter) {
    if (quarter && lattice != Lattice::square)
        throw std::invalid_argument{"only the square lattice is its own mirror image"};
}

GridColumns columns_of(const exact::GasGrid& grid) {
    GridColumns columns;
    for (std::size_t j = 0; j < grid.ny; ++j) {
        for (std::size_t i = 0; i < grid.nx; ++i) {
            const exact::GasState2D& cell = grid.at(i, j);
            columns.x[0].push_back(grid.x(i)), columns.x[1].push_back(grid.y(j));
            columns.v[0].push_back(cell.vx), columns.v[1].push_back(cell.vy);
            columns.m.push_back(cell.rho * grid.dx() * grid.dy());
            columns.rho.push_back(cell.rho), columns.p.push_back(cell.p);
        }
    }
    return columns;
}

Column radii(const Columns<2>& x) {
    Column r;
    for (std::size_t i = 0; i < x[0].size(); ++i) r.push_back(std::hypot(x[0][i], x[1][i]));
    return r;
}

Column radial(const Columns<2>& x, const Columns<2>& v) {
    Column v_r;
    for (std::size_t i = 0; i < x[0].size(); ++i) {
        const double r = std::hypot(x[0][i], x[1][i]);
        v_r.push_back(r > 0 ? (x[0][i] * v[0][i] + x[1][i] * v[1][i]) / r : 0);
    }
    return v_r;
}

Rings ring_means(const Column& r, const Column& f, const Column& w, double dr, double r_end) {
    const auto count = static_cast<std::size_t>(r_end / dr);
    Column weight(count), place(count), value(count);
    for (std::size_t i = 0; i < r.size(); ++i) {
        const auto k = static_cast<std::size_t>(r[i] / dr);
        if (k >= count) continue;
        weight[k] += w[i];
        place[k] += w[i] * r[i];
        value[k] += w[i] * f[i];
    }
    Rings rings;
    for (std::size_t k = 0; k < count; ++k) {
        if (weight[k] == 0) continue;
        rings.r.push_back(place[k] / weight[k]);
        rings.value.push_back(value[k] / weight[k]);
    }
    return rings;
}

double outermost_rise(const Rings& rings, double level) {
    for (std::size_t k = rings.r.size(); k-- > 1;) {
        if (rings.value[k - 1] < level || rings.value[k] >= level) continue;
        const double part = (rings.value[k - 1] - level) / (rings.value[k - 1] - rings.value[k]);
        return rings.r[k - 1] + part * (rings.r[k] - rings.r[k - 1]);
    }
    return 0;
}

}  // namespace sph::shocks
