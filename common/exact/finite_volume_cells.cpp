#include <algorithm>
#include <cmath>

#include "common/exact/finite_volume.hpp"
#include "common/exact/require.hpp"

namespace exact {
namespace {

constexpr const char* problem = "row of cells";

void append(GasCells& cells, double begin, double end, std::size_t n, const Riemann::State& state) {
    for (std::size_t i = 1; i <= n; ++i) {
        cells.faces.push_back(std::lerp(begin, end, static_cast<double>(i) / static_cast<double>(n)));
        cells.states.push_back(state);
    }
}

}  // namespace

GasCells uniform_cells(double begin, double end, std::size_t n, const Riemann::State& state) {
    require(begin < end, problem, "end", end, "begin < end");
    GasCells cells{{begin}, {}};
    append(cells, begin, end, n, state);
    return cells;
}

GasCells uniform_tube(double begin, double jump, double end, std::size_t n, const Riemann::State& left,
                      const Riemann::State& right) {
    GasCells cells = uniform_cells(begin, end, n, left);
    for (std::size_t i = 0; i < n; ++i) {
        if (cells.centre(i) >= jump) cells.states[i] = right;
    }
    return cells;
}

GasCells equal_mass_tube(double begin, double jump, double end, std::size_t n, const Riemann::State& left,
                         const Riemann::State& right) {
    require(begin < jump && jump < end, problem, "jump", jump, "begin < jump < end");
    require(n >= 2, problem, "number of cells", static_cast<double>(n), "2 and above");
    const double mass_left = left.rho * (jump - begin), mass_right = right.rho * (end - jump);
    const double share = static_cast<double>(n) * mass_left / (mass_left + mass_right);
    const auto n_left =
        static_cast<std::size_t>(std::clamp(std::round(share), 1.0, static_cast<double>(n - 1)));
    GasCells cells{{begin}, {}};
    append(cells, begin, jump, n_left, left);
    append(cells, jump, end, n - n_left, right);
    return cells;
}

}  // namespace exact
