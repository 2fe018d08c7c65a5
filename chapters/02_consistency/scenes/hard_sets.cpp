#include "chapters/02_consistency/scenes/hard_sets.hpp"

#include <algorithm>

#include "chapters/01_kernel_interpolation/scenes/test_function.hpp"

namespace sph::consistency {
namespace {

using Plane = interpolation::TestFunction<2>;

/// The slopes of one way to solve, CSPM's and the least-squares one.
template <class Solve>
std::pair<Vector<2>, Vector<2>> slopes(const HardSet& set) {
    Particles<2, Position, Volume, Quantity, MatrixGradient<Solve>, LinearGradient<Solve>> particles{
        set.neighbours.size() + 1};
    for (std::size_t j = 0; j < particles.size(); ++j) {
        const Vector<2> x = j == 0 ? Vector<2>{} : set.neighbours[j - 1];
        for (std::size_t a = 0; a < 2; ++a) particles.x[a][j] = x[a];
        particles.A[j] = x[0] + x[1] + x[0] * x[0] - x[1] * x[1] + x[0] * x[1];
        particles.V[j] = 0.5;
    }
    Neighbours<2> neighbours;
    const ConstantH<AnyKernel<2>> smoothing{1, AnyKernel<2>{"quintic"}};
    neighbours.find(particles.x, smoothing.reach());
    sum_over_neighbours(particles, neighbours, smoothing,
                        Effects{MatrixGradient<Solve>{}, LinearGradient<Solve>{.h = smoothing.h}});
    return {load<2>(particles, 0, List<MatrixGradient<Solve>>{}).matrix,
            load<2>(particles, 0, List<LinearGradient<Solve>>{}).linear};
}

}  // namespace

HardSet band(double width) {
    HardSet set{"nearly on a line", {}};
    for (int k = -3; k <= 3; ++k) {
        if (k == 0) continue;
        const double along = 0.6 * k, across = (k % 2 == 0 ? 0.5 : -0.5) * width;
        set.neighbours.push_back({0.8 * along - 0.6 * across, 0.6 * along + 0.8 * across});
    }
    return set;
}

std::vector<HardSet> hard_sets() {
    HardSet line = band(0);
    line.name = "six on a line";
    return {{"none", {}},
            {"one, at (0.5, 0)", {{0.5, 0.0}}},
            {"two on a line", {{0.5, 0.5}, {-0.7, -0.7}}},
            line,
            {"three in its own place", {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}}},
            {"two in one place", {{0.3, 0.4}, {0.3, 0.4}}},
            {"one at the edge of the support", {{2.9999, 0.0}}}};
}

HardSlopes hard_slopes(const HardSet& set) {
    HardSlopes result;
    std::tie(result.naive, result.naive_linear) = slopes<NaiveSolve>(set);
    std::tie(result.guarded, result.guarded_linear) = slopes<GuardedSolve>(set);
    return result;
}

namespace {

/// n x n random particles of the unit square, with the listed estimates of chapter 1's
/// function.
template <class... Listed>
auto random_particles(std::size_t n, std::uint64_t seed) {
    return InterpolationWithin<AnyKernel<2>, Free, Listed...>{Free{},
                                                              make_points<2>(Arrangement::random, n, 0, seed),
                                                              0.8 / static_cast<double>(n),
                                                              Plane{},
                                                              true,
                                                              1,
                                                              AnyKernel<2>{"cubic"}};
}

}  // namespace

RandomPlane random_plane(std::size_t n, std::uint64_t seed) {
    auto naive = random_particles<MatrixGradient<NaiveSolve>>(n, seed);
    auto guarded = random_particles<MatrixGradient<>, Extent>(n, seed);
    const auto& unguarded = naive.estimate();
    auto particles = guarded.estimate();
    const auto before_repair = particles;
    RandomPlane plane;
    plane.repairs = repair(particles, Free{}, guarded.smoothing(), [](double h) {
        return Effects{MatrixGradient<>{}, Extent{.h = h}};
    });
    double largest = 0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const Vector<2> exact = Plane::gradient(naive.position(i));
        const auto miss = [&](const Columns<2>& slope) {
            return std::hypot(slope[0][i] - exact[0], slope[1][i] - exact[1]);
        };
        largest = std::max(largest, std::hypot(exact[0], exact[1]));
        if (before_repair.extent[0][i] < 1e-12) {
            ++plane.singular;
            plane.naive = std::numeric_limits<double>::infinity();
        } else {
            plane.naive = std::max(plane.naive, miss(unguarded.matrix));
        }
        plane.guarded = std::max(plane.guarded, miss(before_repair.matrix));
        plane.repaired = std::max(plane.repaired, miss(particles.matrix));
    }
    for (double* error : {&plane.naive, &plane.guarded, &plane.repaired}) *error /= largest;
    return plane;
}

}  // namespace sph::consistency
