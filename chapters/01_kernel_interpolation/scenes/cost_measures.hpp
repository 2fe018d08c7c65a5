#pragma once
#include <string>
#include <vector>

#include "chapters/01_kernel_interpolation/scenes/measured.hpp"
#include "common/report/chapter.hpp"

/// CPU time of interpolations and of finite differences. Times are of one thread, the best of several
/// samples, for evaluation alone: the particles are sorted beforehand, the neighbours looked for each time.
namespace sph::interpolation {

inline constexpr double ns = 1e9;  // in a second

/// CPU nanoseconds a point of an interpolation's listed estimates.
template <class Interpolant>
double ns_per_point(report::Run& run, Interpolant& A) {
    const report::Timing timing = run.time([&] { report::keep(&A.estimate()); });
    return ns * timing.best / static_cast<double>(A.size());
}

/// The same for the gradient (2.14) with a kernel of kernel_names(), which its pass is compiled for: times
/// are compared. d = 1, 2. Throws std::invalid_argument for another kernel.
template <int d>
double gradient_ns_per_point(report::Run& run, const Setting& setting);
extern template double gradient_ns_per_point<1>(report::Run&, const Setting&);
extern template double gradient_ns_per_point<2>(report::Run&, const Setting&);

/// The competitor: its name, label, relative L2 error of the slope, and CPU nanoseconds a point.
struct MeasuredDifferences {
    std::string name, label;
    double error = 0, ns = 0;
};

/// Central differences on even points, three-point differences on others.
std::vector<MeasuredDifferences> differences_1d(report::Run& run, Arrangement arrangement, std::size_t n,
                                                double jitter);
/// Central differences of both components on the n x n lattice.
std::vector<MeasuredDifferences> differences_2d(report::Run& run, std::size_t n);

}  // namespace sph::interpolation
