// Every smoothing with every kernel: what a pair is beyond the support, and how the pass moves padding there.
#include <catch2/catch.hpp>

#include "tests/effects/smoothings.hpp"

using namespace sph;
using namespace sph::tested;

namespace {

/// All that a smoothing gives which must vanish with the distance.
template <int d>
std::vector<Tile> shapes(const Pair<d, Tile>& pair) {
    return {pair.W, pair.F, pair.d2W};
}
template <int d>
std::vector<Tile> shapes(const SidedPair<d>& pair) {
    return {pair.F_i, pair.F_j};
}
template <int d>
std::vector<Tile> shapes(const AnyPair<d>& pair) {
    return std::visit([](const auto& of_kind) { return shapes<d>(of_kind); }, pair);
}
int zeros(const Tile& tile) {
    int lanes = 0;
    for (std::size_t lane = 0; lane < tile_width; ++lane) lanes += tile[lane] == 0 ? 1 : 0;
    return lanes;
}

template <int d>
void check_support() {
    constexpr int eight = static_cast<int>(tile_width);
    Random random{5};
    for (const Smoothing<d>& smoothing : all_smoothings<d>()) {
        INFO(smoothing.name << " in " << d << "D");
        for (const double farthest : {1 + 2e-9, 2.0, 1000.0}) {
            const Surroundings<d> around{random, smoothing, 1 + 1e-9, farthest};
            for (const Tile& shape : shapes<d>(smoothing.pair(around.i, around.eight())))
                CHECK(zeros(shape) == eight);
        }
        // Just within the support there is something: W and F, or at least one of two F.
        const Surroundings<d> around{random, smoothing, 0.98, 0.99};
        const auto within = shapes<d>(smoothing.pair(around.i, around.eight()));
        const bool two = smoothing.sides == Sides::both;
        CHECK(zeros(two ? within[0].abs() + within[1].abs() : within[0] * within[1]) == 0);
        // And so far away as padding is.
        const auto padded = shapes<d>(smoothing.pair(around.i, around.eight(3)));
        for (const Tile& shape : padded) CHECK(zeros(shape) >= eight - 3);
    }
}

}  // namespace

/// An effect that looks at the lanes of a tile.
namespace padding {

/// How many lanes a pass visits at which W is zero, and the largest distance of any lane.
struct Vanished {
    static constexpr std::string_view name = "lanes without W";
    template <class T, int>
    struct In {
        T lanes{};
    };
};
struct Farthest {
    static constexpr std::string_view name = "distance of the farthest lane";
    static constexpr bool maximum = true;
    template <class T, int>
    struct In {
        T farthest{};
    };
};
struct Probe {
    using Adds = List<Vanished, Farthest>;
    void add(const auto&, const auto&, const auto& pair, auto& sum) const {
        sum.lanes += (pair.W <= 0).select(1.0, 0.0);
        sum.farthest = sum.farthest.max(pair.r);
    }
};

}  // namespace padding
using namespace padding;

TEST_CASE("W, F and W'' of every smoothing and every kernel are zero beyond the support, and not within") {
    // Fails for a support that is shorter than the kernel, or longer, and for < in the place of <=.
    check_support<1>();
    check_support<2>();
    check_support<3>();
}

TEST_CASE("a pass pads its tiles as these tests do") {
    // Fails if a pass moves its padding elsewhere: then neighbours_of() must follow.
    const ConstantH<CubicSpline<2>> smoothing{0.5};
    for (std::size_t n = 1; n <= 2 * tile_width; ++n) {
        Particles<2, Position, Vanished, Farthest> particles{n};
        Random random{6};
        for (Column& x : particles.x) {
            for (double& place : x) place = random.in({0, 0.6});  // all see each other
        }
        Neighbours<2> neighbours;
        neighbours.find(particles.x, smoothing.reach());
        sum_over_neighbours(particles, neighbours, smoothing, Effects{Probe{}});
        const double unused = static_cast<double>((tile_width - n % tile_width) % tile_width);
        for (std::size_t i = 0; i < n; ++i) {
            CHECK(particles.lanes[i] == unused);
            const double expected = unused > 0 ? 1e3 * smoothing.reach() : 0;
            CHECK(std::abs(particles.farthest[i] - expected) < smoothing.reach());
        }
    }
}
