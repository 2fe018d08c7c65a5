#include "chapters/03_euler_sph/scenes/star_energy.hpp"

#include "chapters/03_euler_sph/scenes/forms.hpp"
#include "chapters/03_euler_sph/scenes/star_rest.hpp"
#include "common/exact/toy_star.hpp"
#include "common/exact/toy_star_modes.hpp"

namespace sph {
namespace {

using K = CubicSpline<1>;
using Star = StarGas<ConsistentH<K>>;
using Motion = Star::Motion;

/// Means over whole periods, and the line through them.
class Drift {
  public:
    explicit Drift(double period) : period_{period} {}
    void add(double t, double value) {
        const auto now = static_cast<long>(t / period_);
        if (now != window_) close();
        window_ = now;
        sum_ += value;
        ++count_;
    }
    /// Slope times the time covered. The last, incomplete period does not count.
    double total() const {
        const auto n = static_cast<double>(means_.size());
        if (means_.size() < 2) return 0;
        double x = 0, y = 0, xx = 0, xy = 0;
        for (std::size_t k = 0; k < means_.size(); ++k) {
            const auto w = static_cast<double>(k);
            x += w / n;
            y += means_[k] / n;
            xx += w * w / n;
            xy += w * means_[k] / n;
        }
        return n * (xy - x * y) / (xx - x * x);
    }

  private:
    void close() {
        if (count_ > 0) means_.push_back(sum_ / static_cast<double>(count_));
        sum_ = 0;
        count_ = 0;
    }
    double period_, sum_ = 0;
    long window_ = 0, count_ = 0;
    std::vector<double> means_;
};

/// Makes the steps that `step(t)` makes, and watches energy and momentum.
template <class Step>
EnergyHistory watch(Star& gas, double A_0, double period, long steps, Step&& step) {
    gas.rates(0);
    const double start = gas.energy();
    Drift drift{period};
    EnergyHistory history;
    double t = 0, low = 0, high = 0, mass = 0;
    for (const double m : gas.particles.m) mass += m;
    for (long k = 1; k <= steps; ++k) {
        step(t);
        const double change = gas.energy() / start - 1;
        drift.add(t, change);
        if (t < period) {
            low = std::min(low, change);
            high = std::max(high, change);
        }
        history.momentum = std::max(history.momentum, std::abs(gas.momentum()[0]) / (mass * A_0));
        if (k % std::max(1L, steps / 500) != 0) continue;
        history.t.push_back(t);
        history.change.push_back(change);
    }
    history.amplitude = (high - low) / 2;
    history.drift = drift.total();
    history.steps = steps;
    return history;
}

/// Drift-kick-drift leaves the density of the middle: the energy wants that of the end.
template <class Integrator>
EnergyHistory with(Star& gas, double A_0, double period, long steps, double dt) {
    Integrator integrator{gas.counters()};
    return watch(gas, A_0, period, steps, [&](double& t) {
        integrator.step(gas.particles, t, dt, [&](double now) { gas.rates(now); });
        if constexpr (!std::is_same_v<Integrator, KickDriftKick<Motion>>) gas.resolve(t);
    });
}

struct NonConservingH : WithoutOmega<K> {
    using WithoutOmega<K>::WithoutOmega;
    using Force = NonConservingForce;
};

/// The attraction of all particles by each other (Monaghan 2005, 6.15): a linear force towards their common
/// centre, wherever that is.
struct MutualAttraction {
    double Omega;
    const double* centre;  // kept up to date by the scene
    using ReadsI = List<Position>;
    using Writes = List<Acceleration>;
    void finish(const auto& i, const auto&, auto& out) const {
        out.dv_dt[0] -= Omega * Omega * (i.x[0] - *centre);
    }
};

double mean(const Column& m, const Column& value) {
    double sum = 0, mass = 0;
    for (std::size_t i = 0; i < m.size(); ++i) {
        sum += m[i] * value[i];
        mass += m[i];
    }
    return sum / mass;
}

/// The centre of mass over time; returns the largest momentum over mass times amplitude.
template <class Resolution>
double follow_centre(const StarScene& scene, const Resolution& resolution, double amplitude, double time,
                     Column& t_out, Column& centre_out) {
    using Alone = Gas<Resolution, Barotropic<Polytrope>, Free, MutualAttraction>;
    double centre = 0, t = 0, largest = 0;
    Alone gas{scene.n, resolution, {scene.state()}, Free{}, scene.threads, MutualAttraction{1, &centre}};
    fill_star(gas.particles, scene, resolution);
    auto& p = gas.particles;
    for (std::size_t i = 0; i < scene.n; ++i)
        p.v[0][i] = amplitude * exact::toy_star_velocity(scene.gamma, 3, p.x[0][i]);
    const double drift = mean(p.m, p.v[0]);
    for (double& v : p.v[0]) v -= drift;
    const auto rates = [&](double now) {
        centre = mean(p.m, p.x[0]);
        gas.rates(now);
    };
    rates(0);
    const double dt = gas.time_step(0.3, [&](std::size_t i) { return p.m[i] / p.rho[i]; });
    KickDriftKick<typename Alone::Motion> integrator{gas.counters()};
    const auto steps = static_cast<long>(std::ceil(time / dt));
    for (long k = 0; k < steps; ++k) {
        integrator.step(p, t, dt, rates);
        largest = std::max(largest, std::abs(mean(p.m, p.v[0])) / amplitude);
        if (k % std::max(1L, steps / 400) != 0) continue;
        t_out.push_back(t);
        centre_out.push_back(mean(p.m, p.x[0]));
    }
    return largest;
}

}  // namespace

EnergyHistory run_star_energy(const StarScene& scene, const std::string& name, double A_0, double courant,
                              long steps) {
    Star gas = star_gas(scene, ConsistentH<K>{HRule{1.2}});
    relax(gas);
    auto& p = gas.particles;
    const exact::ToyStar exact{scene.gamma, scene.state().K, 1, A_0, 1, 1};
    const double period = exact.period();
    const auto limit = [&] {
        return gas.time_step(courant, [&](std::size_t i) { return p.m[i] / p.rho[i]; });
    };
    const double dt = limit();
    for (std::size_t i = 0; i < scene.n; ++i) p.v[0][i] = A_0 * p.x[0][i];
    const auto rates = [&](double t) { gas.rates(t); };
    EnergyHistory history;
    if (name == "kick-drift-kick") {
        history = with<KickDriftKick<Motion>>(gas, A_0, period, steps, dt);
    } else if (name == "drift-kick-drift") {
        history = with<DriftKickDrift<Motion>>(gas, A_0, period, steps, dt);
    } else if (name == "RK4") {
        history = with<RungeKutta4<Motion>>(gas, A_0, period, steps, dt);
    } else if (name == "reversible steps") {
        ReversibleSteps<Motion> integrator{gas.counters()};
        double step = dt;
        history = watch(gas, A_0, period, steps, [&](double& t) {
            integrator.step(p, t, step, rates, limit);
            gas.resolve(t);
        });
    } else if (name == "naive steps") {
        KickDriftKick<Motion> integrator{gas.counters()};
        history = watch(gas, A_0, period, steps, [&](double& t) { integrator.step(p, t, limit(), rates); });
    } else {
        throw std::invalid_argument{"no such integrator: " + name};
    }
    history.dt = dt;
    return history;
}

CentreRun run_centres(const StarScene& scene, double amplitude, double time) {
    CentreRun run;
    run.conserving_momentum = follow_centre(scene, ConsistentH<K>{HRule{1.2}}, amplitude, time,
                                            run.conserving_t, run.conserving_centre);
    run.momentum = follow_centre(scene, NonConservingH{HRule{1.2}}, amplitude, time, run.t, run.centre);
    return run;
}

}  // namespace sph
