// What surrounds a pass: ghosts of the scene's own, receivers that are no particles, refusals, counters.
#include <catch2/catch.hpp>
#include <csignal>
#include <stdexcept>

#include "common/app/program.hpp"
#include "common/core/pass.hpp"
#include "tests/common/app/child.hpp"
#include "tests/common/core/test_kernel.hpp"

using namespace sph;

TEST_CASE("a ghost carries what the scene says") {
    // One particle at 0.1, a wall at 0: its ghost at -0.1 has the mass 7, whatever the particle has.
    const auto make = [](const Columns<1>& x, double, std::vector<Ghost<1>>& ghosts) {
        ghosts.push_back({0, {{-x[0][0]}}, {{-1.0}}});
    };
    GhostsOf boundary{make, [](auto& row, const Ghost<1>& ghost) {
                          if constexpr (requires { row.m; }) row.m = ghost.x[0] < 0 ? 7 : 0;
                      }};
    Neighbours<1, decltype(boundary)> neighbours{boundary};
    Particles<1, Position, Mass, Density> particles{1};
    particles.x[0][0] = 0.1;
    particles.m[0] = 2;
    neighbours.find(particles.x, 1);
    sum_over_neighbours(particles, neighbours, test::Constant{1}, Effects{test::SummedDensity{}});
    CHECK(particles.rho[0] == Approx(2 + 7 * std::pow(1 - 0.04, 2)).epsilon(1e-15));
}

TEST_CASE("sums at other points than the particles") {
    // Fails if receivers and sources are mixed up. The point far away has no neighbours: its sum is zero.
    Particles<1, Position, Mass> sources{20};
    for (std::size_t j = 0; j < 20; ++j) {
        sources.x[0][j] = 0.05 * static_cast<double>(j);
        sources.m[j] = 1 + static_cast<double>(j);
    }
    Particles<1, Position, Density> points{3};
    points.x[0] = {0.31, 5.0, 0.77};
    Neighbours<1> neighbours;
    const double h = 0.12;
    neighbours.find_around(points.x, std::array{h}, sources.x);
    sum_over_neighbours(points, sources, neighbours, test::Constant{h}, Effects{test::SummedDensity{}});
    for (std::size_t i = 0; i < 3; ++i) {
        double rho = 0;
        for (std::size_t j = 0; j < 20; ++j) {
            const double x = points.x[0][i] - sources.x[0][j];
            const double s = test::Bump::deficit(x * x, h);
            rho += sources.m[j] * s * s;
        }
        CHECK(points.rho[i] == Approx(rho).epsilon(1e-14));
    }
    CHECK(points.rho[1] == 0);
}

TEST_CASE("a pass refuses particles whose neighbours were not found") {
    // Fails if the rows are made from columns of another length.
    Particles<1, Position, Mass, Density> particles{5}, more{6};
    Neighbours<1> neighbours;
    const Effects effects{test::SummedDensity{}};
    CHECK_THROWS_AS(sum_over_neighbours(particles, neighbours, test::Constant{1}, effects), std::logic_error);
    neighbours.find(particles.x, 1);
    CHECK_NOTHROW(sum_over_neighbours(particles, neighbours, test::Constant{1}, effects));
    CHECK_THROWS_AS(sum_over_neighbours(more, neighbours, test::Constant{1}, effects), std::logic_error);
    CHECK_THROWS_AS(sum_over_neighbours(more, particles, neighbours, test::Constant{1}, effects),
                    std::logic_error);
}

TEST_CASE("counters tell what was done") {
    Particles<1, Position, Mass, Pressure, Density, Acceleration> particles{10};
    for (std::size_t i = 0; i < 10; ++i) particles.x[0][i] = static_cast<double>(i);
    Neighbours<1> neighbours;
    neighbours.find(particles.x, 1.5);
    CHECK(neighbours.pairs() == 28);  // 10 with themselves, 9 pairs in both directions
    const Effects effects{test::SummedDensity{}, test::PressureForce{}, test::Spring{}};
    sum_over_neighbours(particles, neighbours, test::Constant{1.5}, effects);
    neighbours.find(particles.x, 1.5, Support::gather, Keep::nothing);
    sum_over_neighbours(particles, neighbours, test::Constant{1.5}, effects);
    const Counters& counters = neighbours.counters();
    CHECK(counters.searches == 2);
    CHECK(counters.passes == 2);
    CHECK(counters.pairs == 56);
    CHECK(counters.evaluations == 112);  // two of the three effects are sums over pairs
}

TEST_CASE("Ctrl-C is heard within a pass") {
    // Fails if a pass does not look: it ends, and status 0 or 1 is returned.
    const auto outcome = child::run([] {
        return app::run([] {
            Particles<1, Position, Mass, Density> particles{10};
            Neighbours<1> neighbours;
            neighbours.find(particles.x, 1);
            std::raise(SIGINT);
            sum_over_neighbours(particles, neighbours, test::Constant{1}, Effects{test::SummedDensity{}});
            throw std::runtime_error{"went on"};
        });
    });
    CHECK(outcome.status == 130);
}
