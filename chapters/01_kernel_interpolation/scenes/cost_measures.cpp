#include "chapters/01_kernel_interpolation/scenes/cost_measures.hpp"

#include <algorithm>
#include <stdexcept>

#include "chapters/01_kernel_interpolation/interpolation.hpp"
#include "chapters/01_kernel_interpolation/scenes/finite_differences.hpp"
#include "chapters/01_kernel_interpolation/scenes/test_function.hpp"
#include "common/report/norms.hpp"

namespace sph::interpolation {

template <int d>
double gradient_ns_per_point(report::Run& run, const Setting& s) {
    double result = 0;
    const bool known = with_kernel<d>(s.kernel, [&](auto kernel) {
        Interpolation<decltype(kernel), DifferenceGradient> A{
            make_points<d>(s.arrangement, s.per_side, s.jitter, s.seed), s.h(), TestFunction<d>{}};
        result = ns_per_point(run, A);
    });
    if (!known) throw std::invalid_argument{"unknown kernel " + s.kernel};
    return result;
}
template double gradient_ns_per_point<1>(report::Run&, const Setting&);
template double gradient_ns_per_point<2>(report::Run&, const Setting&);

namespace {

/// Values and exact slopes of the test function on points in 1D, from left to right, and its slope by
/// differences.
struct Line {
    plot::Values x, A, exact, slope;
    Line(Arrangement arrangement, std::size_t n, double jitter, std::uint64_t seed)
        : x{make_points<1>(arrangement, n, jitter, seed)[0]}, slope(n) {
        std::sort(x.begin(), x.end());
        for (const double position : x) {
            A.push_back(TestFunction<1>::value({position}));
            exact.push_back(TestFunction<1>::gradient({position})[0]);
        }
    }
};

}  // namespace

std::vector<MeasuredDifferences> differences_1d(report::Run& run, Arrangement arrangement, std::size_t n,
                                                double jitter) {
    Line line{arrangement, n, jitter, run.seed()};
    std::vector<MeasuredDifferences> result;
    const auto measure = [&](std::string name, std::string label, const auto& scheme) {
        const report::Timing timing = run.time([&] {
            scheme();
            report::keep(line.slope.data());
        });
        result.push_back({std::move(name), std::move(label), report::l2_error(line.slope, line.exact),
                          ns * timing.best / static_cast<double>(n)});
    };
    if (arrangement == Arrangement::even) {
        measure("central-2", "differences, 2nd order", [&] { central_2(line.A, line.slope); });
        measure("central-4", "differences, 4th order", [&] { central_4(line.A, line.slope); });
    } else {
        measure("three-point", "three-point differences", [&] { three_point(line.x, line.A, line.slope); });
    }
    return result;
}

std::vector<MeasuredDifferences> differences_2d(report::Run& run, std::size_t n) {
    plot::Values A(n * n), slope_x(n * n), slope_y(n * n);
    const Columns<2> lattice = make_points<2>(Arrangement::even, n, 0, 0);
    for (std::size_t i = 0; i < n * n; ++i) A[i] = TestFunction<2>::value({lattice[0][i], lattice[1][i]});
    const report::Timing timing = run.time([&] {
        central_gradient_2d(A, n, slope_x, slope_y);
        report::keep(slope_x.data());
    });
    plot::Values slope = slope_x, exact;
    slope.insert(slope.end(), slope_y.begin(), slope_y.end());
    for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
        for (std::size_t i = 0; i < n * n; ++i) {
            exact.push_back(TestFunction<2>::gradient({lattice[0][i], lattice[1][i]})[axis]);
        }
    }
    const double error = report::l2_error(slope, exact);
    return {{"central-2", "differences, 2nd order", error, ns * timing.best / static_cast<double>(n * n)}};
}

}  // namespace sph::interpolation
