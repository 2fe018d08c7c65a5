// Only what a scene lists is there: in memory, in code, in time.
#include <atomic>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <new>
#include <type_traits>

#include "common/core/integrators.hpp"
#include "tests/common/core/test_kernel.hpp"

#ifndef SPH_SANITIZED  // which is an allocator of its own
namespace {
// Counts every allocation of this test program; the only way to see one is to be the allocator.
std::atomic<long> allocations{0};
}  // namespace

void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc{};
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    ++allocations;
    const auto align = static_cast<std::size_t>(alignment);
    if (void* memory = std::aligned_alloc(align, (size + align - 1) / align * align)) return memory;
    throw std::bad_alloc{};
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}

#endif

using namespace sph;

namespace {

/// An effect whose body does not compile, and whose column does not exist.
struct Poison {
    struct Nowhere;
    using Reads = List<Nowhere>;
    using Adds = List<Nowhere>;
    void add(const auto& i, const auto&, const auto&, auto& sum) const { sum.nowhere += i.nowhere.at_all(); }
};

template <bool poisoned>
auto effects() {
    if constexpr (poisoned) {
        return Effects{test::SummedDensity{}, Poison{}};
    } else {
        return Effects{test::SummedDensity{}};
    }
}

}  // namespace

TEST_CASE("an effect that is not listed is not compiled") {
    // The pass below would not compile if Poison were instantiated.
    Particles<2, Position, Mass, Density> particles{4};
    Neighbours<2> neighbours;
    neighbours.find(particles.x, 1);
    sum_over_neighbours(particles, neighbours, test::Constant{1}, effects<false>());
    CHECK(particles.rho[0] == 0);
}

TEST_CASE("what a scene does not list takes no memory") {
    constexpr std::size_t header = sizeof(Particles<3>);
    // A column is its vectors and nothing else; an absent one is nothing.
    STATIC_REQUIRE(sizeof(Particles<3, Position, Mass>) == header + 4 * sizeof(Column));
    STATIC_REQUIRE(sizeof(Particles<3, Position, Mass, Velocity>) == header + 7 * sizeof(Column));
    // The row that pairs read holds what the effects name: mass, pressure; with friction velocities too.
    using One = decltype(Effects{test::PressureForce{}});
    using Two = decltype(Effects{test::PressureForce{}, test::Friction{}});
    STATIC_REQUIRE(count_components<3>(One::ReadJ{}) == 2);
    STATIC_REQUIRE(count_components<3>(Two::ReadJ{}) == 5);
    // Two effects that add to one column share a sum.
    STATIC_REQUIRE(count_components<3>(Two::Summed{}) == 3);
    // An effect without parameters takes no space in the list either.
    STATIC_REQUIRE(sizeof(One) == 1);
    STATIC_REQUIRE(std::is_empty_v<Neighbours<3>> == false);
    CHECK(sizeof(RowOf<Tile, 3, One::Summed>) == 3 * sizeof(Tile));
}

#ifndef SPH_SANITIZED
TEST_CASE("a step allocates nothing once the first ones are done") {
    // Fails if a pass, a search, the team or an integrator makes a temporary column.
    constexpr std::size_t n = 4000;
    Particles<2, Position, Velocity, Mass, Pressure, Density, Acceleration, SmoothingLength> particles{n};
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t row = i / 64;
        particles.x[0][i] = 0.01 * static_cast<double>(i % 64);
        particles.x[1][i] = 0.01 * static_cast<double>(row);
        particles.v[0][i] = i % 2 == 0 ? 0.1 : -0.1;
        particles.m[i] = particles.p[i] = particles.rho[i] = 1;
        particles.h[i] = i % 3 == 0 ? 0.03 : 0.012;
    }
    const Box<2> box{{{0.0, 0.0}}, {{0.64, 0.63}}, Face::periodic};
    Neighbours<2, Box<2>> neighbours{box, 2};
    const auto rates = [&](double) {
        neighbours.find(particles.x, particles.h, Support::symmetric);
        sum_over_neighbours(particles, neighbours, test::Mean{},
                            Effects{test::SummedDensity{}, test::PressureForce{}, test::Friction{}});
    };
    double t = 0;
    Motion motion{neighbours.team()};
    motion.evolve<Position, Velocity>(particles).evolve<Velocity, Acceleration>(particles).watch(particles);
    RungeKutta4 runge_kutta{motion, rates};
    KickDriftKick leapfrog{motion, rates};
    const auto steps = [&](int count) {
        for (int k = 0; k < count; ++k) {
            runge_kutta.step(t, 1e-5);
            leapfrog.step(t, 1e-5);
        }
    };
    steps(3);
    const long before = allocations;
    CHECK(before > 0);  // the counter counts
    steps(10);
    CHECK(allocations - before == 0);
}
#endif
