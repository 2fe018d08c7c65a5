#include "common/plot/contour.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace plot {
namespace {

struct Node {
    std::uint64_t id = 0;
    Point at;
    double value = 0;
};
/// Where the contour crosses the edge between two nodes; the key is the same seen from both sides of the
/// edge.
struct Crossing {
    std::uint64_t key = 0;
    Point at;
};
using Crossings = std::vector<Crossing>;  // two in a row are the ends of a segment

class Marcher {
  public:
    Marcher(const Field& field, double level) : field_{field}, level_{level} {
        for (std::size_t row = 0; row + 1 < field.y.size(); ++row)
            for (std::size_t column = 0; column + 1 < field.x.size(); ++column) cell(row, column);
    }
    const Crossings& segments() const { return segments_; }

  private:
    Node corner(std::size_t row, std::size_t column) const {
        const std::size_t id = row * field_.x.size() + column;
        return {id, {field_.x[column], field_.y[row]}, field_.value[id]};
    }
    bool above(const Node& node) const { return node.value >= level_; }

    void cell(std::size_t row, std::size_t column) {
        const double* low = &field_.value[row * field_.x.size() + column];
        const double* high = low + field_.x.size();
        const bool first = low[0] >= level_;  // most cells end here
        if ((low[1] >= level_) == first && (high[0] >= level_) == first && (high[1] >= level_) == first)
            return;
        const std::array<Node, 4> ring{corner(row, column), corner(row, column + 1),
                                       corner(row + 1, column + 1), corner(row + 1, column)};
        Node centre{field_.value.size() + ring[0].id,
                    {(ring[0].at.x + ring[1].at.x) / 2, (ring[0].at.y + ring[3].at.y) / 2},
                    0};
        for (const auto& node : ring) centre.value += node.value / 4;
        for (std::size_t k = 0; k < 4; ++k) triangle({ring[k], ring[(k + 1) % 4], centre});
    }

    void triangle(const std::array<Node, 3>& nodes) {
        for (std::size_t k = 0; k < 3; ++k)
            if (above(nodes[k]) != above(nodes[(k + 1) % 3]))
                segments_.push_back(crossing(nodes[k], nodes[(k + 1) % 3]));
    }

    Crossing crossing(Node a, Node b) const {
        if (a.id > b.id) std::swap(a, b);
        const double t = (level_ - a.value) / (b.value - a.value);
        const std::uint64_t nodes = 2 * field_.value.size();
        return {a.id * nodes + b.id, {a.at.x + t * (b.at.x - a.at.x), a.at.y + t * (b.at.y - a.at.y)}};
    }

    const Field& field_;
    double level_;
    Crossings segments_;
};

constexpr std::size_t none = ~std::size_t{0};

/// For each segment end the end of the neighbouring segment that meets it, or none.
std::vector<std::size_t> partners(const Crossings& ends) {
    std::vector<std::size_t> order(ends.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::pair{ends[a].key, a} < std::pair{ends[b].key, b};
    });
    std::vector<std::size_t> result(ends.size(), none);
    for (std::size_t k = 1; k < order.size(); ++k)
        if (ends[order[k]].key == ends[order[k - 1]].key) {
            result[order[k]] = order[k - 1];
            result[order[k - 1]] = order[k];
        }
    return result;
}

}  // namespace

std::vector<Polyline> contour_lines(const Field& field, double level) {
    const Marcher marcher{field, level};
    const Crossings& ends = marcher.segments();
    const auto partner = partners(ends);
    std::vector<bool> used(ends.size());
    std::vector<Polyline> lines;
    const auto follow = [&](std::size_t end) {
        if (used[end]) return;
        Polyline& line = lines.emplace_back(Polyline{ends[end].at});
        while (end != none && !used[end]) {
            const std::size_t other = end ^ 1U;  // of the same segment
            used[end] = used[other] = true;
            line.push_back(ends[other].at);
            end = partner[other];
        }
    };
    for (std::size_t k = 0; k < ends.size(); ++k)
        if (partner[k] == none) follow(k);
    for (std::size_t k = 0; k < ends.size(); ++k) follow(k);
    return lines;
}

}  // namespace plot
