// What an effect claims about i and j exchanged: that momentum and energy are conserved hangs on it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include "tests/effects/subjects.hpp"

using namespace sph;
using namespace sph::tested;

namespace {

/// What a neighbour gives to i, and i to it.
struct Exchanged {
    double to_i, to_j;
};

/// How far terms are from either parity, relative to the largest of their tile: the worst of all pairs.
struct Mismatch {
    double antisymmetric = 0, symmetric = 0;
    double of(Parity parity) const { return parity == Parity::symmetric ? symmetric : antisymmetric; }
};
using Key = std::pair<std::size_t, Weight>;  // number of the column, and what it is weighted by
using Mismatches = std::map<Key, Mismatch>;

void compare(const std::vector<Exchanged>& terms, Mismatch& worst) {
    double largest = 0, sum = 0, difference = 0;
    for (const auto& [to_i, to_j] : terms) {
        if (!std::isfinite(to_i + to_j)) {  // a maximum would not see it
            worst.antisymmetric = worst.symmetric = std::numeric_limits<double>::infinity();
            return;
        }
        largest = std::max({largest, std::abs(to_i), std::abs(to_j)});
        sum = std::max(sum, std::abs(to_i + to_j));
        difference = std::max(difference, std::abs(to_i - to_j));
    }
    if (largest == 0) return;
    worst.antisymmetric = std::max(worst.antisymmetric, sum / largest);
    worst.symmetric = std::max(worst.symmetric, difference / largest);
}

/// One receiver and eight neighbours, of which some see i and are not seen, or the other way.
template <int d>
void compare_tile(Random& random, const AnyEffect<d>& effect, const Smoothing<d>& smoothing,
                  Mismatches& worst) {
    const Surroundings<d> around{random, smoothing, 0, 1};
    const Numbers<d>& i = around.i;
    const auto near = around.eight();
    const Sums to_i = effect.add(i, near, smoothing.pair(i, near));
    std::array<Sums, tile_width> to_j;
    for (std::size_t lane = 0; lane < tile_width; ++lane) {
        const auto back = neighbours_of<d>(around.near[lane], std::span{&i, 1});
        to_j[lane] = effect.add(around.near[lane], back, smoothing.pair(around.near[lane], back));
    }
    for (std::size_t c = 0; c < to_i.size(); ++c) {
        for (const Weight by : all_weights) {
            std::vector<Exchanged> terms;
            for (std::size_t k = 0; k < to_i[c].size(); ++k) {
                for (std::size_t lane = 0; lane < tile_width; ++lane)
                    terms.push_back({weight(i, by) * to_i[c][k][lane],
                                     weight(around.near[lane], by) * to_j[lane][c][k][0]});
            }
            compare(terms, worst[{c, by}]);
        }
    }
}

/// Of all smoothings in which i and j see kernels of that kind.
template <int d>
Mismatches mismatches(const AnyEffect<d>& effect, Sides sides) {
    constexpr int tiles = 6;
    Random random{4};
    Mismatches worst;
    for (const Smoothing<d>& smoothing : all_smoothings<d>()) {
        if (smoothing.sides == sides) {
            for (int k = 0; k < tiles; ++k) compare_tile<d>(random, effect, smoothing, worst);
        }
    }
    return worst;
}

/// The smallest mismatch of a column over all weights and both parities.
double least(const Mismatches& worst, std::size_t column) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const auto& [key, mismatch] : worst) {
        if (key.first == column) smallest = std::min({smallest, mismatch.antisymmetric, mismatch.symmetric});
    }
    return smallest;
}

constexpr double rounding = 1e-14;  // measured: 8e-16 at most
constexpr double clearly = 0.1;     // measured: 0.8 at least

void check_claims(const Subject& subject, const Mismatches& worst, Sides sides) {
    for (std::size_t c = 0; c < subject.claims.size(); ++c) {
        const Claim& claim = subject.claims[c];
        INFO("column " << c);
        const bool held_here = sides == Sides::same || !claim.one_kernel_only;
        if (claim.parity == Parity::neither || !held_here) {
            CHECK(least(worst, c) > clearly);
        } else {
            const Mismatch& mismatch = worst.at({c, claim.by});
            CHECK(mismatch.of(claim.parity) < rounding);
            const bool antisymmetric = claim.parity == Parity::antisymmetric;
            CHECK(mismatch.of(antisymmetric ? Parity::symmetric : Parity::antisymmetric) > clearly);
        }
    }
}

template <int d>
void check_parity(const Subject& subject) {
    const AnyEffect<d>* effect = subject.in<d>();
    if (!effect) return;
    for (const Sides sides : {Sides::same, Sides::both}) {
        if (sides == Sides::both && !subject.sided) continue;
        const Mismatches worst = mismatches<d>(*effect, sides);
        INFO(subject.name << " in " << d << "D, " << (sides == Sides::same ? "one kernel" : "two"));
        REQUIRE(worst.size() == subject.claims.size() * all_weights.size());
        check_claims(subject, worst, sides);
    }
}

}  // namespace

TEST_CASE("each effect is antisymmetric, symmetric or neither, as it is declared") {
    // Fails for the pressure of i in the place of that of j, a wrong sign of one of two terms, a mass too
    // few, and for a table that says what is not so.
    for (const Subject& subject : all_subjects()) {
        check_parity<1>(subject);
        check_parity<2>(subject);
        check_parity<3>(subject);
    }
}

TEST_CASE("where each particle gathers with its own h, nothing cancels") {
    // Shows that the test above sees a smoothing that is not symmetric.
    int columns = 0;
    for (const Subject& subject : all_subjects()) {
        const Mismatches worst = mismatches<1>(*subject.in<1>(), Sides::own);
        for (std::size_t c = 0; c < subject.claims.size(); ++c) {
            if (subject.claims[c].parity != Parity::antisymmetric) continue;
            INFO(subject.name);
            CHECK(worst.at({c, subject.claims[c].by}).antisymmetric > clearly);
            ++columns;
        }
    }
    CHECK(columns > 20);
}
