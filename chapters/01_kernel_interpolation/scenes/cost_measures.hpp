#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "chapters/01_kernel_interpolation/scenes/finite_differences.hpp"
#include "chapters/01_kernel_interpolation/interpolation.hpp"
#include "chapters/01_kernel_interpolation/scenes/measured.hpp"
#include "chapters/01_kernel_interpolation/scenes/test_function.hpp"
#include "common/plot/figure.hpp"
#include "common/report/chapter.hpp"
#include "common/report/norms.hpp"

/// CPU time of interpolations and of finite differences. Times are of one thread, the best of several
/// samples, for evaluation alone: the particles are sorted beforehand.
namespace sph {

inline constexpr double ns = 1e9;  // in a second

/// CPU nanoseconds a particle for the listed estimates with the kernel K.
template <class K, class... Listed>
double ns_per_point(report::Run& run, const Setting& s) {
    constexpr int d = K::dimension;
    Interpolation<K, Listed...> A{make_points<d>(s.arrangement, s.per_side, s.jitter, s.seed),
                                  s.h_over_dx / static_cast<double>(s.per_side), TestFunction<d>{}};
    const report::Timing timing = run.time([&] { report::keep(&A.estimate()); });
    return ns * timing.best / static_cast<double>(A.size());
}

/// A competitor: its name, label, error, and CPU nanoseconds a point.
struct Competitor {
    std::string name, label;
    double error = 0, ns = 0;
};

/// Central differences on even points, three-point differences on others: relative L2 error of the slope, and
/// cost.
std::vector<Competitor> differences_1d(report::Run& run, Arrangement arrangement, std::size_t n,
                                       double jitter);
/// Central differences of both components on the n x n lattice.
std::vector<Competitor> differences_2d(report::Run& run, std::size_t n);

}  // namespace sph
