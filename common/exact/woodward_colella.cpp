#include "common/exact/woodward_colella.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/exact/finite_volume.hpp"
#include "common/exact/require.hpp"
#include "common/exact/woodward_colella_table.hpp"

namespace exact {
namespace {

constexpr const char* problem = "Woodward-Colella blast waves";

/// The slopes of the lines from a node that pass others within the tolerance.
struct Cone {
    double low = -std::numeric_limits<double>::infinity(), high = -low;

    bool holds(double slope) const { return slope >= low && slope <= high; }
    void narrow(double slope, double margin) {
        low = std::max(low, slope - margin);
        high = std::min(high, slope + margin);
    }
    bool empty() const { return low > high; }
};

std::array<double, 3> values(const WoodwardColella::Node& node) {
    return {node.rho, node.v, node.p};
}

}  // namespace

WoodwardColella::WoodwardColella() : cells_{woodward_colella_table_cells()} {
    const auto table = woodward_colella_table();
    nodes_.assign(table.begin(), table.end());
}

WoodwardColella::WoodwardColella(std::size_t cells, const std::function<void()>& pause) : cells_{cells} {
    require(cells >= 10 && cells <= 1'000'000, problem, "number of cells", static_cast<double>(cells),
            "10..1000000");
    GasCells gas = uniform_cells(0, 1, cells, {1, 0, 0.01});
    for (std::size_t i = 0; i < cells; ++i) {
        if (gas.centre(i) < 0.1) gas.states[i].p = 1000;
        if (gas.centre(i) > 0.9) gas.states[i].p = 100;
    }
    FiniteVolume solver{gas,
                        {.gamma = gamma,
                         .frame = Frame::lagrangian,
                         .left = End::reflecting,
                         .right = End::reflecting,
                         .courant = 0.4,
                         .quiet_shocks = true}};
    constexpr int parts = 100;
    for (int part = 1; part <= parts; ++part) {
        if (pause) pause();
        solver.advance_to(part == parts ? time : part * time / parts);
    }
    gas = solver.cells();
    // Towards a wall the last state goes on, but the gas at the wall rests.
    const auto wall = [&](double x, const Riemann::State& next) {
        nodes_.push_back({x, next.rho, 0, next.p});
    };
    wall(0, gas.states.front());
    for (std::size_t i = 0; i < cells; ++i) {
        const auto& [rho, v, p] = gas.states[i];
        nodes_.push_back({gas.centre(i), rho, v, p});
    }
    wall(1, gas.states.back());
}

Riemann::Point WoodwardColella::at(double x) const {
    require(x >= 0 && x <= 1, problem, "x", x, "0..1");
    const auto after = std::upper_bound(nodes_.begin() + 1, nodes_.end() - 1, x,
                                        [](double place, const Node& node) { return place < node.x; });
    const Node &a = after[-1], &b = *after;
    const double part = (x - a.x) / (b.x - a.x);
    const double rho = std::lerp(a.rho, b.rho, part), p = std::lerp(a.p, b.p, part);
    return {rho, std::lerp(a.v, b.v, part), p, p / ((gamma - 1) * rho)};
}

// From each kept node the farthest one is kept to which a line passes all between: of these, the lines that
// pass every node so far are a cone, which narrows from node to node.
std::vector<WoodwardColella::Node> WoodwardColella::thinned(double tolerance) const {
    require(tolerance > 0, problem, "tolerance", tolerance, "above 0");
    double fastest = 0;
    for (const Node& node : nodes_) fastest = std::max(fastest, std::abs(node.v));
    std::vector<Node> kept{nodes_.front()};
    for (std::size_t from = 0; from + 1 < nodes_.size();) {
        std::size_t farthest = from + 1;
        std::array<Cone, 3> cones;
        for (std::size_t k = from + 1; k < nodes_.size(); ++k) {
            const double dx = nodes_[k].x - nodes_[from].x;
            const auto here = values(nodes_[k]), start = values(nodes_[from]);
            const std::array<double, 3> scales{here[0], fastest / 2, here[2]};
            bool all_hold = true, any_empty = false;
            for (std::size_t c = 0; c < 3; ++c) {
                const double slope = (here[c] - start[c]) / dx;
                all_hold = all_hold && cones[c].holds(slope);
                cones[c].narrow(slope, tolerance * scales[c] / dx);
                any_empty = any_empty || cones[c].empty();
            }
            if (all_hold) farthest = k;
            if (any_empty) break;
        }
        from = farthest;
        kept.push_back(nodes_[from]);
    }
    return kept;
}

}  // namespace exact
