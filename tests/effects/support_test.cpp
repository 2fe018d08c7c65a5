// An effect sums its neighbours and nothing else: exact zeros beyond the support and in lanes of padding.
#include <catch2/catch.hpp>

#include "tests/effects/subjects.hpp"

using namespace sph;
using namespace sph::tested;

namespace {

/// Calls visit(subject, effect, smoothing) for each effect with each smoothing that it can be used with, in
/// one dimension after the other.
template <int d, class Visit>
void for_each_use_in(Visit&& visit) {
    for (const Subject& subject : all_subjects()) {
        if (const AnyEffect<d>* effect = subject.in<d>()) {
            for (const Smoothing<d>& smoothing : all_smoothings<d>()) {
                if (subject.sided || smoothing.sides != Sides::both) visit(subject, *effect, smoothing);
            }
        }
    }
}
template <class Visit>
void for_each_use(Visit&& visit) {
    for_each_use_in<1>(visit);
    for_each_use_in<2>(visit);
    for_each_use_in<3>(visit);
}

/// Lanes first..7 in which any sum is not exactly zero: what is no number is not zero.
int not_zero(const Sums& sums, std::size_t first = 0) {
    int lanes = 0;
    for (const auto& column : sums) {
        for (const Tile& tile : column) {
            for (std::size_t lane = first; lane < tile_width; ++lane) lanes += tile[lane] == 0 ? 0 : 1;
        }
    }
    return lanes;
}
/// Whether the first lanes of two sums are the same numbers.
bool same(const Sums& a, const Sums& b, std::size_t lanes) {
    for (std::size_t c = 0; c < a.size(); ++c) {
        for (std::size_t k = 0; k < a[c].size(); ++k) {
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                if (!(a[c][k][lane] == b[c][k][lane])) return false;
            }
        }
    }
    return true;
}

}  // namespace

TEST_CASE("beyond the support no effect adds anything") {
    // Just behind the end of the support, and far away. Fails for a term without its W or F, and for 0 times
    // what is not finite.
    Random random{1};
    int uses = 0, seen = 0;
    for_each_use([&]<int d>(const Subject& subject, const AnyEffect<d>& effect,
                            const Smoothing<d>& smoothing) {
        const Surroundings<d> outside{random, smoothing, 1 + 1e-9, 1.5}, away{random, smoothing, 10, 1000};
        const Surroundings<d> inside{random, smoothing, 0, 0.99};
        int wrong = 0;
        for (const auto* around : {&outside, &away}) {
            const auto j = around->eight();
            wrong += not_zero(effect.add(around->i, j, smoothing.pair(around->i, j)));
        }
        const auto j = inside.eight();
        seen += not_zero(effect.add(inside.i, j, smoothing.pair(inside.i, j))) > 0 ? 1 : 0;
        ++uses;
        if (wrong > 0) {
            INFO(subject.name << " in " << d << "D, " << smoothing.name);
            CHECK(wrong == 0);
        }
    });
    CHECK(seen > 0.99 * uses);  // there is something to vanish; measured: 9570 of 9580
    CHECK(uses > 5000);
}

TEST_CASE("lanes behind the last neighbour add nothing, and change no other lane") {
    // Fails for a maximum or a count that does not ask for W or F, and for an exponential without a bound.
    Random random{2};
    int tiles = 0;
    for_each_use(
        [&]<int d>(const Subject& subject, const AnyEffect<d>& effect, const Smoothing<d>& smoothing) {
            const Surroundings<d> around{random, smoothing, 0, 0.99};
            const auto all = around.eight();
            const Sums full = effect.add(around.i, all, smoothing.pair(around.i, all));
            int wrong = 0;
            for (std::size_t used = 1; used < tile_width; ++used) {
                const auto j = around.eight(used);
                const Sums sums = effect.add(around.i, j, smoothing.pair(around.i, j));
                wrong += not_zero(sums, used) + (same(sums, full, used) ? 0 : 1);
                ++tiles;
            }
            if (wrong > 0) {
                INFO(subject.name << " in " << d << "D, " << smoothing.name);
                CHECK(wrong == 0);
            }
        });
    CHECK(tiles > 10000);
}

TEST_CASE("a particle and itself: finite, and no exchange") {
    // Every receiver is a neighbour of itself, at r = 0. Fails for a division by r without a bound.
    Random random{3};
    int exchanges = 0;
    for_each_use(
        [&]<int d>(const Subject& subject, const AnyEffect<d>& effect, const Smoothing<d>& smoothing) {
            const Numbers<d> i = particle<d>(random);
            const auto j = neighbours_of<d>(i, std::span{&i, 1});
            const Sums sums = effect.add(i, j, smoothing.pair(i, j));
            int wrong = 0;
            for (std::size_t c = 0; c < sums.size(); ++c) {
                const bool exchanges_nothing = subject.claims[c].parity == Parity::antisymmetric;
                for (const Tile& tile : sums[c])
                    wrong += (exchanges_nothing ? tile[0] == 0 : std::isfinite(tile[0])) ? 0 : 1;
                exchanges += exchanges_nothing ? 1 : 0;
            }
            if (wrong > 0) {
                INFO(subject.name << " in " << d << "D, " << smoothing.name);
                CHECK(wrong == 0);
            }
        });
    CHECK(exchanges > 1000);
}
