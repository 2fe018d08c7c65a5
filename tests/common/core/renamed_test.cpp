// An effect under other names of its columns, and the price of listed effects alone.
#include "common/core/renamed.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "common/core/listed.hpp"
#include "tests/common/core/test_kernel.hpp"

using namespace sph;

/// Columns of the shape of a mass, a pressure and an acceleration.
namespace electric {

struct Charge {
    static constexpr std::string_view name = "charge";
    template <class T, int>
    struct In {
        T charge{};
    };
};
struct Potential {
    static constexpr std::string_view name = "potential";
    template <class T, int>
    struct In {
        T potential{};
    };
};
struct Current {
    static constexpr std::string_view name = "current";
    template <class T, int d>
    struct In {
        Vec<T, d> current{};
    };
};

}  // namespace electric

using namespace electric;

namespace {

using Pushed =
    Renamed<test::PressureForce, As<Mass, Charge>, As<Pressure, Potential>, As<Acceleration, Current>>;
using Rubbed = Renamed<test::Friction, As<Mass, Charge>, As<Acceleration, Current>>;

}  // namespace

TEST_CASE("a renamed effect names its columns anew") {
    // Fails if a name stays, or if one that is not renamed is lost.
    using P = decltype(Effects{Pushed{}});
    STATIC_REQUIRE(std::is_same_v<P::ReadI, List<Potential>>);
    STATIC_REQUIRE(std::is_same_v<P::ReadJ, List<Potential, Charge>>);
    STATIC_REQUIRE(std::is_same_v<P::Summed, List<Current>>);
    using R = decltype(Effects{Rubbed{}});
    STATIC_REQUIRE(std::is_same_v<R::ReadI, List<Velocity>>);
    STATIC_REQUIRE(std::is_same_v<R::Stored, List<Current>>);
}

TEST_CASE("an effect under other column names gives bitwise the same sums") {
    // Fails if a column is exchanged with another, or if the effect's parameter is lost.
    constexpr std::size_t n = 60;
    Particles<2, Position, Velocity, Mass, Pressure, Acceleration, Charge, Potential, Current> particles{n};
    for (std::size_t i = 0; i < n; ++i) {
        const auto k = static_cast<double>(i);
        particles.x[0][i] = std::fmod(0.618 * k, 1.0);
        particles.x[1][i] = std::fmod(0.414 * k, 1.0);
        particles.v[0][i] = std::sin(k);
        particles.v[1][i] = std::cos(2 * k);
        particles.m[i] = particles.charge[i] = 1 + 0.1 * std::sin(3 * k);
        particles.p[i] = particles.potential[i] = 2 + std::cos(k);
    }
    Neighbours<2> neighbours;
    neighbours.find(particles.x, 0.3);
    const test::Constant smoothing{0.3};
    sum_over_neighbours(particles, neighbours, smoothing,
                        Effects{test::PressureForce{}, test::Friction{0.7}});
    sum_over_neighbours(particles, neighbours, smoothing, Effects{Pushed{}, Rubbed{{0.7}}});
    CHECK(particles.current == particles.dv_dt);
    CHECK(particles.current[0][5] != 0);
    CHECK(neighbours.counters().evaluations == 4 * static_cast<long>(neighbours.pairs()));
}

TEST_CASE("listed effects alone: only their columns, and one pass") {
    // Fails if a column too many is there (it would be paid for), or if the smoothing's is missing.
    Columns<2> x;
    for (std::size_t i = 0; i < 16; ++i) {
        x[0].push_back(static_cast<double>(i % 4));
        x[1].push_back(static_cast<double>(i / 4));
    }
    Listed density{x, Free{}, 1.5, 1.5, test::Constant{1.5}, test::SummedDensity{}};
    CHECK(density.size() == 16);
    CHECK(density.columns() == 4);  // x, y, m, rho
    CHECK(density.pairs() == 16 + 2 * 24 + 2 * 18);
    CHECK_NOTHROW(density.pass());
    Listed forces{x, Free{}, 1.5, 1.5, test::Mean{}, test::PressureForce{}, test::Friction{}};
    CHECK(forces.columns() == 2 + 2 + 2 + 3);  // x, v, dv_dt; m, p, h
    CHECK_NOTHROW(forces.pass());
}
