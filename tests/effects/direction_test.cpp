// The sign of each effect, which an exchange of i and j does not see: what its terms follow.
#include <catch2/catch.hpp>

#include "tests/effects/subjects.hpp"

using namespace sph;
using namespace sph::tested;

namespace {

struct Signs {
    int along = 0, against = 0;
    bool follows() const { return along > 0 && against == 0; }
};

/// How the column's terms lie: a vector to a vector, the trace of a tensor to a number.
template <int d>
Signs signs(const AnyEffect<d>& effect, const Smoothing<d>& smoothing, std::size_t column, Along along) {
    constexpr int tiles = 50;
    Random random{7};
    Signs found;
    for (int t = 0; t < tiles; ++t) {
        Surroundings<d> around{random, smoothing, 0, 0.99};
        around.i.v_mid = around.i.v;
        for (Numbers<d>& j : around.near) j.v_mid = j.v;
        const auto eight = around.eight();
        const auto term = effect.add(around.i, eight, smoothing.pair(around.i, eight))[column];
        for (std::size_t lane = 0; lane < tile_width; ++lane) {
            const auto to = direction(along, between<d>(around.i, around.near[lane]));
            const bool trace = to.size() == 1 && term.size() == d * d;
            if (!trace && to.size() != term.size()) return {};
            double product = 0;
            for (std::size_t a = 0; a < (trace ? d : to.size()); ++a)
                product += trace ? term[a * (d + 1)][lane] * to[0] : term[a][lane] * to[a];
            found.along += product > 0 ? 1 : 0;
            found.against += product >= 0 ? 0 : 1;  // nor what is no number
        }
    }
    return found;
}

template <int d>
void check(const Subject& subject) {
    const AnyEffect<d>* effect = subject.in<d>();
    if (!effect) return;
    for (const Smoothing<d>& smoothing : smoothings_with<d>("cubic")) {  // W >= 0 and F <= 0
        if (smoothing.sides == Sides::both && !subject.sided) continue;
        INFO(subject.name << " in " << d << "D, " << smoothing.name);
        for (std::size_t c = 0; c < subject.claims.size(); ++c) {
            INFO("column " << c);
            const Along claimed = subject.claims[c].along;
            if (claimed != Along::nothing) {
                CHECK(signs<d>(*effect, smoothing, c, claimed).follows());
                continue;
            }
            for (const Along along : all_directions) {
                INFO("direction " << static_cast<int>(along));
                CHECK(!signs<d>(*effect, smoothing, c, along).follows());
            }
        }
    }
}

}  // namespace

TEST_CASE("each effect acts in the direction that is declared, or in none") {
    // Fails for a += in the place of a -=, and for i - j in the place of j - i.
    for (const Subject& subject : all_subjects()) {
        check<1>(subject);
        check<2>(subject);
        check<3>(subject);
    }
}
