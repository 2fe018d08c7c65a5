#include "chapters/02_consistency/scenes/length_rules.hpp"

#include "chapters/01_kernel_interpolation/scenes/test_function.hpp"
#include "chapters/02_consistency/scenes/graded_line.hpp"
#include "chapters/02_consistency/smoothing_lengths.hpp"
#include "common/report/norms.hpp"

namespace sph::consistency {
namespace {

using K = AnyKernel<1>;
constexpr double h_over_dx = 1.2;
K kernel() {
    return K{"quintic"};
}

/// A force between pairs, m_i m_j (1/rho_i + 1/rho_j) grad_i W_ij: cancels in the sum if the kernel is
/// symmetric.
struct PairForce {
    using Reads = List<Density>;
    using ReadsJ = List<Mass>;
    using Adds = List<Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.dv_dt -= (j.m * (1 / i.rho + 1 / j.rho) * pair.F) * pair.x_ij;
    }
};

using Line = Particles<1, Position, Mass, Density, Volume, Quantity, SmoothingLength, Value, Acceleration>;

/// Errors and forces of a line whose sums are made.
GradedRun measure(const Line& line, std::size_t pairs) {
    GradedRun result;
    Column rho, exact_rho, value, exact_value;
    double net = 0, size = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        net += line.m[i] * line.dv_dt[0][i];
        size += std::abs(line.m[i] * line.dv_dt[0][i]);
        const double x = line.x[0][i];
        if (x < 0.2 || x > 0.8) continue;  // away from the ends, which are another matter
        result.x.push_back(x);
        result.h.push_back(line.h[i]);
        rho.push_back(line.rho[i]);
        exact_rho.push_back(GradedLine::density(x));
        result.rho_error.push_back(rho.back() / exact_rho.back() - 1);
        value.push_back(line.value[i]);
        exact_value.push_back(line.A[i]);
    }
    result.l2_rho = report::l2_error(rho, exact_rho);
    result.l2_value = report::l2_error(value, exact_value);
    result.net_force = std::abs(net) / size;
    result.neighbours = static_cast<double>(pairs) / static_cast<double>(line.size());
    return result;
}

/// Density, then the interpolated wave and the forces, with one rule for h. `follow` sets h from the
/// densities.
template <class Smoothing, class Follow>
GradedRun run_line(std::size_t n, const Smoothing& smoothing, Support support, Follow&& follow) {
    Line line{n};
    line.x[0] = GradedLine::positions(n);
    line.m.assign(n, 1.0 / static_cast<double>(n));
    line.h.assign(n, h_over_dx / static_cast<double>(n));
    Neighbours<1> neighbours;
    const auto sum_density = [&] {
        Column reach = line.h;
        for (double& r : reach) r *= smoothing.kernel.support;
        neighbours.find(line.x, reach, support);
        sum_over_neighbours(line, neighbours, smoothing, Effects{SummedDensity{}});
    };
    constexpr int rounds = 30;  // h and rho settle geometrically
    for (int round = 0; round < rounds; ++round) {
        sum_density();
        follow(line);
    }
    sum_density();
    for (std::size_t i = 0; i < n; ++i) {
        line.V[i] = line.m[i] / line.rho[i];
        line.A[i] = interpolation::TestFunction<1>::value({line.x[0][i]});
    }
    sum_over_neighbours(line, neighbours, smoothing, Effects{Value{}, PairForce{}});
    return measure(line, neighbours.pairs());
}

void by_own_density(Line& line) {
    for (std::size_t i = 0; i < line.size(); ++i) line.h[i] = h_over_dx * line.m[i] / line.rho[i];
}
void by_mean_density(Line& line) {
    line.h.assign(line.size(), mean_density_h(line.rho, line.m[0], h_over_dx, 1));
}
void by_nothing(Line&) {}

}  // namespace

GradedRun run_mean_kernel(std::size_t n, Support support) {
    return run_line(n, MeanKernel<K>{kernel()}, support, by_own_density);
}

const std::vector<LengthRule>& length_rules() {
    const auto mean_h = [](void (*follow)(Line&)) {
        return [=](std::size_t n) { return run_line(n, MeanH<K>{kernel()}, Support::symmetric, follow); };
    };
    static const std::vector<LengthRule> all{
        {"global", "one $h$, mean spacing", "one h, mean spacing", mean_h(by_nothing)},
        {"mean-density", "one $h$ (2.9)", "one h, mean density (2.9)", mean_h(by_mean_density)},
        {"own-h", "own $h_{i}$", "own h_i",
         [](std::size_t n) { return run_line(n, OwnH<K>{kernel()}, Support::gather, by_own_density); }},
        {"mean-h", "mean $h$ (2.10)", "mean of both h (2.10)", mean_h(by_own_density)},
        {"mean-kernel", "mean kernel (2.11)", "mean of both kernels (2.11)",
         [](std::size_t n) { return run_mean_kernel(n, Support::symmetric); }}};
    return all;
}

}  // namespace sph::consistency
