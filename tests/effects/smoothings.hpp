#pragma once
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "tests/effects/numbers.hpp"

/// All smoothings of the book, under one type, so that effects are compiled for what a pair is and not for
/// how it was made.
namespace sph::tested {

template <int d>
using AnyPair = std::variant<Pair<d, Tile>, SidedPair<d>>;

/// Whether i and j see the same W and F; or each its own and both that of the other; or each its own only.
enum class Sides { same, both, own };

template <int d>
struct Smoothing {
    std::string name;
    Sides sides;
    /// The distance from which i sees nothing of j.
    std::function<double(const Numbers<d>& i, const Numbers<d>& j)> reach;
    std::function<AnyPair<d>(const Numbers<d>& i, const Eight<d>& j)> pair;
};

template <int d, class H>
AnyPair<d> any(const Pair<d, H>& pair) {
    return Pair<d, Tile>{pair.x_ij, pair.r, pair.W, pair.F, pair.d2W, Tile(pair.h)};
}
template <int d>
AnyPair<d> any(const SidedPair<d>& pair) {
    return pair;
}

/// `h_of(i, j)` is the smoothing length that reaches farthest.
template <int d, class S, class H>
Smoothing<d> smoothing(std::string name, Sides sides, const S& made, H h_of) {
    const double support = made.kernel.support;
    return {std::move(name), sides,
            [=](const Numbers<d>& i, const Numbers<d>& j) { return support * h_of(i, j); },
            [=](const Numbers<d>& i, const Eight<d>& j) { return any(made.pair(i, j, j.x_ij)); }};
}

/// Every smoothing with the kernel of that name. They are called like their types.
template <int d>
std::vector<Smoothing<d>> smoothings_with(const std::string& kernel_name) {
    using K = AnyKernel<d>;
    const K kernel{kernel_name};
    static constexpr double h = 0.8;
    const auto constant = [](const auto&, const auto&) { return h; };
    const auto own = [](const auto& i, const auto&) { return i.h; };
    const auto mean = [](const auto& i, const auto& j) { return 0.5 * (i.h + j.h); };
    const auto larger = [](const auto& i, const auto& j) { return std::max(i.h, j.h); };
    return {smoothing<d>("ConstantH", Sides::same, ConstantH<K>{h, kernel}, constant),
            smoothing<d>("OwnH", Sides::own, OwnH<K>{kernel}, own),
            smoothing<d>("MeanH", Sides::same, MeanH<K>{kernel}, mean),
            smoothing<d>("MeanKernel", Sides::same, MeanKernel<K>{kernel}, larger),
            smoothing<d>("BothH", Sides::both, BothH<K>{kernel}, larger)};
}

/// Every smoothing with every kernel.
template <int d>
const std::vector<Smoothing<d>>& all_smoothings() {
    static const std::vector<Smoothing<d>> all = [] {
        std::vector<Smoothing<d>> made;
        for (const std::string& kernel : any_kernel_names()) {
            for (Smoothing<d>& one : smoothings_with<d>(kernel)) {
                made.push_back(std::move(one));
                made.back().name += ", " + kernel;
            }
        }
        return made;
    }();
    return all;
}

/// i and eight neighbours of it, at distances between `nearest` and `farthest` in units of the reach.
template <int d>
struct Surroundings {
    Numbers<d> i;
    std::array<Numbers<d>, tile_width> near;

    Surroundings(Random& random, const Smoothing<d>& smoothing, double nearest, double farthest)
        : i{particle<d>(random)} {
        for (Numbers<d>& j : near) {
            j = particle<d>(random);
            place<d>(random, i, random.in({nearest, farthest}) * smoothing.reach(i, j), j);
        }
    }
    /// The first `count` of them.
    Eight<d> eight(std::size_t count = tile_width) const {
        return neighbours_of<d>(i, std::span{near}.first(count));
    }
};

}  // namespace sph::tested
