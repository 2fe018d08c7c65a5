#include "common/core/neighbours.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "tests/common/core/all_pairs.hpp"

using namespace sph;

namespace {

/// Uniform numbers that are the same on every machine.
class Random {
  public:
    explicit Random(std::uint64_t seed) : bits_{seed} {}
    double number(double low, double high) {
        return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
    }
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(bits_() % n); }
    bool chance(double p) { return number(0, 1) < p; }

  private:
    std::mt19937_64 bits_;
};

template <int d>
struct Set {
    Vector<d> low{}, high{};
    std::array<std::pair<Face, Face>, static_cast<std::size_t>(d)> faces{};
    Columns<d> x;
    std::vector<double> reach;  // one, or one a point
    Support support = Support::gather;
    Keep keep = Keep::list;
};

/// A set of every kind: empty ones, single points, points on top of each other, points on a lattice whose
/// spacing divides the reach (so that many lie exactly at the cut-off and on the faces of cells), boxes of
/// any length, reaches that differ by up to a thousand.
template <int d>
Set<d> random_set(Random& random) {
    Set<d> set;
    const bool lattice = random.chance(0.3);
    const double step = 0.125;
    for (std::size_t a = 0; a < d; ++a) {
        set.low[a] = lattice ? -step * static_cast<double>(random.below(9)) : random.number(-2, 2);
        const double length =
            lattice ? step * static_cast<double>(1 + random.below(12)) : random.number(0.05, 2);
        set.high[a] = set.low[a] + length;
        const std::size_t kind = random.below(5);
        set.faces[a] = kind == 0   ? std::pair{Face::periodic, Face::periodic}
                       : kind == 1 ? std::pair{Face::mirror, Face::mirror}
                       : kind == 2 ? std::pair{Face::mirror, Face::free}
                       : kind == 3 ? std::pair{Face::free, Face::mirror}
                                   : std::pair{Face::free, Face::free};
    }
    const std::size_t n = random.chance(0.05) ? random.below(3) : random.below(d == 1 ? 60 : 40);
    for (std::size_t i = 0; i < n; ++i) {
        const bool twin = i > 0 && random.chance(0.05);
        const std::size_t other = twin ? random.below(i) : 0;
        for (std::size_t a = 0; a < d; ++a) {
            double x = random.number(set.low[a], set.high[a]);
            if (lattice) x = set.low[a] + step * std::floor((x - set.low[a]) / step + 0.5);
            if (set.faces[a].first == Face::periodic && random.chance(0.1))  // it has left the box
                x += (set.high[a] - set.low[a]) * (static_cast<double>(random.below(5)) - 2);
            set.x[a].push_back(twin ? set.x[a][other] : x);
        }
    }
    const double widest =
        lattice ? step * static_cast<double>(1 + random.below(6)) : random.number(0.02, 0.9);
    const double ratio = random.chance(0.5) ? 1 : random.chance(0.5) ? 3 : 1000;
    if (random.chance(0.4)) {
        set.reach = {widest};
    } else {
        for (std::size_t i = 0; i < n; ++i)
            set.reach.push_back(random.chance(0.02) ? 0 : widest * std::pow(ratio, -random.number(0, 1)));
        if (n == 0) set.reach = {widest};
    }
    set.support = random.chance(0.5) ? Support::symmetric : Support::gather;
    set.keep = random.chance(0.3) ? Keep::nothing : Keep::list;
    return set;
}

/// Receivers whose neighbours differ from all-pairs. `engine` has already searched.
template <class N, int d>
int differences(N& engine, const Set<d>& set, const std::vector<all_pairs::Pair<d>>& all) {
    int wrong = 0;
    for (std::size_t r = 0; r < engine.receivers().size(); ++r) {
        const auto& receiver = engine.receivers()[r];
        const auto reach_of = [&](std::size_t i) { return set.reach[set.reach.size() == 1 ? 0 : i]; };
        const auto expected = all_pairs::neighbours<d>(all, receiver.x, [&](std::size_t j) {
            return set.support == Support::symmetric ? std::max(reach_of(receiver.index), reach_of(j))
                                                     : reach_of(receiver.index);
        });
        wrong += !all_pairs::same<d>(expected, all_pairs::found_by(engine, r));
    }
    return wrong;
}

template <int d>
int wrong_receivers(const Set<d>& set, int threads) {
    const double widest = *std::max_element(set.reach.begin(), set.reach.end());
    const Box<d> box{set.low, set.high, set.faces};
    Neighbours<d, Box<d>> engine{box, threads};
    engine.find(set.x, set.reach, set.support, set.keep);
    if (engine.receivers().size() != set.x[0].size()) return -1;
    return differences(engine, set, all_pairs::sources<d>(&box, set.x, widest));
}

template <int d>
void check_random_sets(int count, std::uint64_t seed) {
    Random random{seed};
    int wrong = 0;
    for (int k = 0; k < count; ++k) wrong += wrong_receivers(random_set<d>(random), 1 + k % 2);
    CHECK(wrong == 0);
}

}  // namespace

// Together 10,000 sets over all boundary kinds. Each fails if the search misses a cell (a range one too
// small, a margin left out), takes < for <=, forgets a corner or an image of an image, or a grid of another
// reach.
TEST_CASE("neighbours are those of all pairs: 5000 random sets in 1D") {
    check_random_sets<1>(5000, 1);
}
TEST_CASE("neighbours are those of all pairs: 3500 random sets in 2D") {
    check_random_sets<2>(3500, 2);
}
TEST_CASE("neighbours are those of all pairs: 1500 random sets in 3D") {
    check_random_sets<3>(1500, 3);
}

TEST_CASE("neighbours of many points, with grids of many cells, on one thread and on two") {
    // Fails if blocks of cells are left out, if parts of the list overlap, or if the order depends on
    // threads.
    Random random{4};
    Set<3> set;
    set.high = {{1.0, 1.3, 0.7}};
    set.faces = {
        std::pair{Face::periodic, Face::periodic}, {Face::mirror, Face::mirror}, {Face::free, Face::free}};
    for (int i = 0; i < 3000; ++i) {
        for (std::size_t a = 0; a < 3; ++a) set.x[a].push_back(random.number(0, set.high[a]));
        set.reach.push_back(random.number(0.02, 0.16));
    }
    set.support = Support::symmetric;
    CHECK(wrong_receivers(set, 1) == 0);
    CHECK(wrong_receivers(set, 2) == 0);
    Neighbours<3, Box<3>> one{{set.low, set.high, set.faces}, 1}, two{{set.low, set.high, set.faces}, 2};
    one.find(set.x, set.reach, set.support);
    two.find(set.x, set.reach, set.support);
    REQUIRE(one.pairs() == two.pairs());
    Indices scratch;
    bool equal = true;
    for (std::size_t r = 0; r < one.receivers().size(); ++r) {
        const auto a = one.of(r, scratch), b = two.of(r, scratch);
        equal = equal && std::equal(a.index, a.index + a.count, b.index, b.index + b.count);
    }
    CHECK(equal);
}

TEST_CASE("points around any positions, ghosts included") {
    Random random{5};
    for (int k = 0; k < 200; ++k) {
        Set<2> set = random_set<2>(random);
        Set<2> at = set;
        for (std::size_t a = 0; a < 2; ++a) {
            at.x[a].clear();
            for (int i = 0; i < 15; ++i) at.x[a].push_back(random.number(set.low[a], set.high[a]));
        }
        at.reach.assign(15, 0);
        for (double& reach : at.reach) reach = random.number(0, 0.7);
        at.support = Support::gather;
        const Box<2> box{set.low, set.high, set.faces};
        Neighbours<2, Box<2>> engine{box};
        engine.find_around(at.x, at.reach, set.x, set.keep);
        REQUIRE(engine.receivers().size() == 15);
        CHECK(differences(engine, at, all_pairs::sources<2>(&box, set.x, 0.7)) == 0);
    }
}

TEST_CASE("ghosts through a function of the scene are neighbours like others") {
    // A point has an image turned by 90 degrees about the origin, as in a quarter of a disc.
    Random random{6};
    Set<2> set;
    set.reach = {0.3};
    for (int i = 0; i < 50; ++i) {
        for (std::size_t a = 0; a < 2; ++a) set.x[a].push_back(random.number(0, 1));
    }
    const auto turn = [](const Columns<2>& x, double reach, std::vector<Ghost<2>>& ghosts) {
        for (std::size_t i = 0; i < x[0].size(); ++i) {
            if (x[0][i] < reach)
                ghosts.push_back({static_cast<std::uint32_t>(i), {{-x[1][i], x[0][i]}}, {{1.0, 1.0}}});
        }
    };
    GhostsOf boundary{turn, [](auto&, const auto&) {}};
    Neighbours<2, decltype(boundary)> engine{boundary};
    engine.find(set.x, set.reach);
    CHECK(engine.ghosts() == static_cast<std::size_t>(std::count_if(set.x[0].begin(), set.x[0].end(),
                                                                    [](double x) { return x < 0.3; })));
    auto all = all_pairs::sources<2>(nullptr, set.x, 0.3);
    std::vector<Ghost<2>> ghosts;
    turn(set.x, 0.3, ghosts);
    for (const auto& ghost : ghosts) all.push_back({ghost.owner, ghost.x, ghost.sign});
    CHECK(differences(engine, set, all) == 0);
}

TEST_CASE("a search tests few candidates a neighbour") {
    // Measured: 1.03 in 1D, 1.8 in 2D, 3.2 in 3D. Cells as wide as the reach along x would give 1.5, 2.9
    // and 6.4.
    const auto ratio = [](auto dimension, std::size_t n, double reach) {
        constexpr int d = decltype(dimension)::value;
        Random random{7};
        Columns<d> x;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t a = 0; a < d; ++a) x[a].push_back(random.number(0, 1));
        }
        Vector<d> high{};
        for (double& end : high) end = 1;
        Neighbours<d, Box<d>> engine{Box<d>{{}, high, Face::periodic}};
        engine.find(x, reach);
        std::size_t candidates = 0;
        for (const auto& receiver : engine.receivers())
            candidates += engine.cells().candidates(receiver.x, reach, Support::gather);
        return static_cast<double>(candidates) / static_cast<double>(engine.pairs());
    };
    CHECK(ratio(std::integral_constant<int, 1>{}, 4000, 0.02) < 1.15);
    CHECK(ratio(std::integral_constant<int, 2>{}, 4000, 0.07) < 2.0);
    CHECK(ratio(std::integral_constant<int, 3>{}, 4000, 0.15) < 3.6);
}

TEST_CASE("lists end in whole tiles that repeat the last neighbour") {
    // Fails if the padding is left out: a tile would read what lies behind the list.
    Columns<1> x;
    for (int i = 0; i < 30; ++i) x[0].push_back(0.1 * i);
    Neighbours<1> engine;
    for (const Keep keep : {Keep::list, Keep::nothing}) {
        engine.find(x, 0.35, Support::gather, keep);
        Indices scratch;
        for (std::size_t r = 0; r < 30; ++r) {
            const auto [index, count] = engine.of(r, scratch);
            REQUIRE(count >= 4);
            const std::size_t whole = (count + tile_width - 1) / tile_width * tile_width;
            for (std::size_t k = count; k < whole; ++k) CHECK(index[k] == index[count - 1]);
        }
    }
}

TEST_CASE("a point far away does not slow the search down, and costs no memory") {
    // Without grids of limited size there would be 1e12 cells.
    Columns<2> x;
    for (int i = 0; i < 1000; ++i) {
        x[0].push_back(i % 32);
        x[1].push_back(i / 32);
    }
    x[0].push_back(1e12);
    x[1].push_back(-1e12);
    Neighbours<2> engine;
    engine.find(x, 1.5);
    // A lattice of 32 x 31 points and 8 more in the last row; each sees itself and the eight around.
    Set<2> set;
    set.x = x;
    set.reach = {1.5};
    CHECK(differences(engine, set, all_pairs::sources<2>(nullptr, x, 1.5)) == 0);
}

TEST_CASE("a search refuses what it cannot answer, naming the point") {
    Neighbours<1> engine;
    using Catch::Contains;
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH(engine.find({{{0.0, nan}}}, 1), Contains("coordinate of point 1"));
    CHECK_THROWS_WITH(engine.find({{{0.0, 1.0, -inf}}}, 1), Contains("coordinate of point 2"));
    CHECK_THROWS_WITH(engine.find({{{0.0, 1.0}}}, nan), Contains("reach of point 0"));
    CHECK_THROWS_WITH(engine.find({{{0.0, 1.0}}}, std::vector{1.0, -1.0}), Contains("reach of point 1"));
    CHECK_THROWS_AS(engine.find({{{0.0, 1.0}}}, std::vector{1.0, 1.0, 1.0}), std::invalid_argument);
    CHECK_THROWS_AS(Neighbours<2>{}.find({{{0.0, 1.0}, {0.0}}}, 1), std::invalid_argument);
    CHECK_THROWS_AS((Box<1>{{{1.0}}, {{1.0}}, Face::mirror}), std::invalid_argument);
    CHECK_THROWS_AS((Box<1>{{{0.0}}, {{1.0}}, {std::pair{Face::periodic, Face::free}}}),
                    std::invalid_argument);
    CHECK_THROWS_WITH(engine.find_around({{{0.0, nan}}}, std::array{1.0}, {{{0.0}}}),
                      Contains("coordinate of point 1"));
    CHECK_THROWS_WITH(engine.find_around({{{0.0}}}, std::array{nan}, {{{0.0}}}),
                      Contains("reach of point 0"));
    CHECK_THROWS_AS(engine.find_around({{{0.0, 1.0, 2.0}}}, std::array{1.0, 1.0}, {{{0.0}}}),
                    std::invalid_argument);
    Neighbours<1, Box<1>> tiny{Box<1>{{{0.0}}, {{1e-9}}, Face::periodic}};
    CHECK_THROWS_WITH(tiny.find({{{0.0}}}, 1), Contains("images"));
    CHECK_NOTHROW(engine.find({{{0.0, 1.0}}}, 0));
    CHECK(engine.pairs() == 0);
}
