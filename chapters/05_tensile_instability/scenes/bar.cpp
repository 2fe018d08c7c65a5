#include "chapters/05_tensile_instability/scenes/bar.hpp"

#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "chapters/02_consistency/corrected.hpp"
#include "chapters/05_tensile_instability/liquid.hpp"
#include "chapters/05_tensile_instability/scenes/lattice_growth.hpp"
#include "common/exact/struck_bar.hpp"

namespace sph::tensile {
namespace {

using K = AnyKernel<1>;

// [cspm]
/// d rho/dt = - rho dv/dx,  dv/dt = - (1/rho) dp/dx, both slopes by the quotient of CSPM (Chen 2017, 94).
struct CorrectiveSlopes {
    using Columns = List<DensityRate, Quantity, Volume, MatrixGradient<>>;
    using Drift = Velocity;
    List<> effects() const { return {}; }
    void resolved(auto& p, const auto& sum) const {
        for (std::size_t i = 0; i < p.size(); ++i) p.V[i] = p.m[i] / p.rho[i];
        p.A = p.v[0];
        sum(Effects{MatrixGradient<>{}});
        for (std::size_t i = 0; i < p.size(); ++i) p.drho_dt[i] = -p.rho[i] * p.matrix[0][i];
        p.A = p.p;
        sum(Effects{MatrixGradient<>{}});
        for (std::size_t i = 0; i < p.size(); ++i) p.dv_dt[0][i] = -p.matrix[0][i] / p.rho[i];
    }
};
// [end]

/// Fixed particles on either side: as many as two reaches hold.
std::size_t fixed_at_an_end(const Bar& bar) {
    return static_cast<std::size_t>(std::ceil(2 * K{bar.kernel}.support * bar.h_over_dx));
}

void place(const Bar& bar, const Liquid& state, Simulation<1>& line) {
    const auto n = static_cast<std::size_t>(bar.particles), ends = fixed_at_an_end(bar);
    const auto at = [](std::size_t place) { return Vector<1>{static_cast<double>(place)}; };
    for (std::size_t i = 0; i < n; ++i)  // free ones first, at 1..n
        line.place(i, at(i + 1), {i == (n - 1) / 2 ? bar.push : 0}, 1, state.rho_0, state.P);
    for (std::size_t k = 0; k < ends; ++k) {
        line.place(n + k, -at(k), {0}, 1, state.rho_0, state.P);
        line.place(n + ends + k, at(n + 1 + k), {0}, 1, state.rho_0, state.P);
    }
    line.groups().hold("ends", n, n + 2 * ends);
}

BarRun follow(const Bar& bar, Integrated<1>& line) {
    constexpr double far = 0.1;
    const exact::StruckBar solution{bar.particles, (bar.particles + 1) / 2, bar.push};
    const auto middle = static_cast<std::size_t>((bar.particles - 1) / 2);
    const Column& x = line.get<Position>()[0];
    line.integrate_by<RungeKutta4>();
    line.start(0);
    BarRun run;
    double t = 0;
    march(line, t, {.end = bar.time, .steps = std::lround(bar.time / bar.courant)}, [&](double now) {
        run.t.push_back(now);
        run.u.push_back(x[middle] - static_cast<double>(middle + 1));
        run.exact.push_back(solution.displacement(bar.particles / 2 + bar.particles % 2, now));
        for (std::size_t i = 0; i < static_cast<std::size_t>(bar.particles); ++i) {
            if (std::abs(x[i] - static_cast<double>(i + 1)) < far) continue;
            run.lost = now;
            return false;
        }
        return true;
    });
    return run;
}

template <class Resolution, class Cure>
BarRun run_with(const Bar& bar, Resolution resolution) {
    const Liquid state{bar.pressure, 1, named_lattice<1>(bar.kernel, bar.h_over_dx).density};
    const std::size_t n = static_cast<std::size_t>(bar.particles) + 2 * fixed_at_an_end(bar);
    CuredLiquid<Resolution, Free, Cure> line{n, resolution, state, Free{}, bar.threads};
    place(bar, state, line);
    return follow(bar, line);
}

}  // namespace

double BarRun::error() const {
    double sum = 0, size = 0;
    for (std::size_t k = 0; k < t.size(); ++k) {
        sum += std::abs(u[k] - exact[k]);
        size += std::abs(exact[k]);
    }
    return sum / size;
}

BarRun run_bar(const Bar& bar) {
    if (bar.scheme == BarScheme::sph)
        return run_with<FixedH<K>, Uncured>(bar, {bar.h_over_dx, K{bar.kernel}});
    return run_with<EvolvedDensity<K>, CorrectiveSlopes>(bar, {{bar.h_over_dx, K{bar.kernel}}});
}

}  // namespace sph::tensile
