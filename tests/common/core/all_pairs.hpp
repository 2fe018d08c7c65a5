#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "common/core/neighbours.hpp"

/// The plain way to know neighbours: every particle against every image of every particle. Images are found
/// by walking through the faces one at a time, which shares no formula with Box.
namespace all_pairs {

using sph::Box;
using sph::Face;
using sph::Vector;

/// One source on one axis: where, and with which sign of the vector component.
struct Seen {
    double x, sign;
};

/// All places of x on axis a of the box, within `reach` of it.
template <int d>
std::vector<Seen> places(const Box<d>& box, std::size_t a, double x, double reach) {
    const double low = box.low[a], high = box.high[a];
    const Face first = box.faces[a].first, second = box.faces[a].second;
    std::vector<Seen> found{{x, 1}};
    if (first == Face::periodic) {
        for (const double side : {-1.0, 1.0}) {
            for (int k = 1;; ++k) {
                const double moved = x + side * k * (high - low);
                if (side < 0 ? moved < low - reach : moved > high + reach) break;
                found.push_back({moved, 1});
            }
        }
        return found;
    }
    // A ray of light that starts at the low (high) mirror meets the mirrors in turn.
    const auto walk = [&](bool at_low) {
        Seen seen{x, 1};
        while (true) {
            if ((at_low ? first : second) != Face::mirror) return;
            seen = {2 * (at_low ? low : high) - seen.x, -seen.sign};
            if (seen.x < low - reach || seen.x > high + reach) return;
            found.push_back(seen);
            at_low = !at_low;
        }
    };
    walk(true);
    walk(false);
    return found;
}

/// A neighbour: the particle, and where it is seen.
template <int d>
struct Pair {
    std::uint32_t owner;
    Vector<d> x, sign;
};
template <int d>
bool before(const Pair<d>& a, const Pair<d>& b) {
    if (a.owner != b.owner) return a.owner < b.owner;
    for (std::size_t k = 0; k < d; ++k) {
        if (std::abs(a.x[k] - b.x[k]) > 1e-9) return a.x[k] < b.x[k];
        if (a.sign[k] != b.sign[k]) return a.sign[k] < b.sign[k];
    }
    return false;
}
template <int d>
bool same(const std::vector<Pair<d>>& a, const std::vector<Pair<d>>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto& p, const auto& q) { return !before<d>(p, q) && !before<d>(q, p); });
}

template <int d>
double distance2(const Vector<d>& a, const Vector<d>& b) {
    double r2 = 0;
    for (std::size_t k = 0; k < d; ++k) r2 += (a[k] - b[k]) * (a[k] - b[k]);
    return r2;
}

/// Every image of every particle that lies within the largest reach of the box; without a box, the particles.
template <int d>
std::vector<Pair<d>> sources(const Box<d>* box, const sph::Columns<d>& x, double reach) {
    std::vector<Pair<d>> all;
    for (std::size_t j = 0; j < x[0].size(); ++j) {
        Vector<d> position;
        for (std::size_t a = 0; a < d; ++a) position[a] = x[a][j];
        std::array<std::vector<Seen>, 3> axis{std::vector<Seen>{{0, 1}}, {{0, 1}}, {{0, 1}}};
        if (box) box->wrap(position);
        for (std::size_t a = 0; a < d; ++a)
            axis[a] = box ? places(*box, a, position[a], reach) : std::vector<Seen>{{position[a], 1}};
        for (const Seen& p : axis[0]) {
            for (const Seen& q : axis[1]) {
                for (const Seen& s : axis[2]) {
                    const std::array<Seen, 3> seen{p, q, s};
                    Pair<d> pair{static_cast<std::uint32_t>(j), {}, {}};
                    for (std::size_t a = 0; a < d; ++a) {
                        pair.x[a] = seen[a].x;
                        pair.sign[a] = seen[a].sign;
                    }
                    all.push_back(pair);
                }
            }
        }
    }
    return all;
}

/// Those of `all` that the position sees.
template <int d, class ReachOf>
std::vector<Pair<d>> neighbours(const std::vector<Pair<d>>& all, const Vector<d>& x, ReachOf&& reach_to) {
    std::vector<Pair<d>> found;
    for (const Pair<d>& pair : all) {
        const double reach = reach_to(pair.owner);
        if (distance2(x, pair.x) < reach * reach) found.push_back(pair);
    }
    std::sort(found.begin(), found.end(), before<d>);
    return found;
}

/// What the engine found for its r-th receiver, in the same form.
template <class N>
auto found_by(N& engine, std::size_t r) {
    constexpr int d = N::d;
    sph::Indices scratch;
    const auto [index, count] = engine.of(r, scratch);
    std::vector<Pair<d>> found;
    for (std::size_t k = 0; k < count; ++k) {
        Pair<d> pair{engine.owner(index[k]), engine.source_position(index[k]), {}};
        for (std::size_t a = 0; a < d; ++a) {
            const auto* ghost = engine.ghost(index[k]);
            pair.sign[a] = ghost ? ghost->sign[a] : 1;
        }
        found.push_back(pair);
    }
    std::sort(found.begin(), found.end(), before<d>);
    return found;
}

}  // namespace all_pairs
