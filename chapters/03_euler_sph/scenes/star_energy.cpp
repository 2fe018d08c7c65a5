#include "chapters/03_euler_sph/scenes/star_energy.hpp"

#include <optional>

#include "common/exact/toy_star_modes.hpp"

namespace sph::euler {
namespace {

/// Means over whole periods, and the line through them.
class MeanDrift {
  public:
    explicit MeanDrift(double period) : period_{period} {}
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

/// Half the distance between the largest and the least of some values.
class Range {
  public:
    void add(double value) {
        low_ = std::min(low_, value);
        high_ = std::max(high_, value);
    }
    double half() const { return (high_ - low_) / 2; }

  private:
    double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
};

// [shadow]
/// What kick-drift-kick conserves to dt^4 in place of the energy E: with the accelerations f,
///     H = E - dt^2/24 sum_i m_i (2 v_i . df_i/dt + f_i . f_i)
/// (Monaghan 2005, 5.55 and 5.57 are that of drift-kick-drift). df/dt is the difference of the steps before
/// and after, so H comes a step late.
class ShadowHamiltonian {
  public:
    explicit ShadowHamiltonian(double dt) : dt_{dt} {}
    /// H of the step before this one, from the second step on.
    std::optional<double> next(const LineGas& gas, double energy) {
        const Column& f = gas.get<Acceleration>()[0];
        std::optional<double> H;
        if (!before_.empty()) {
            H = energy_;
            for (std::size_t i = 0; i < f.size(); ++i)
                *H -= gas.get<Mass>()[i] * dt_ * (v_[i] * (f[i] - before_[i]) + dt_ * f_[i] * f_[i]) / 24;
        }
        before_ = std::exchange(f_, f);
        v_ = gas.get<Velocity>()[0];
        energy_ = energy;
        return H;
    }

  private:
    double dt_, energy_ = 0;
    Column f_, before_, v_;  // accelerations at the last step and at the one before, velocities at the last
};
// [end]

/// Lets a gas step by the integrator of that name, with steps of dt, or as long as limit() says.
void integrate_by_name(LineGas& gas, const std::string& name, const std::function<double()>& limit) {
    const double dt = limit();
    gas.limit_steps([dt] { return dt; });
    if (name == "kick-drift-kick") {
        gas.integrate_by<KickDriftKick>();
    } else if (name == "drift-kick-drift") {
        gas.integrate_by<DriftKickDrift>();
    } else if (name == "RK4") {
        gas.integrate_by<RungeKutta4>();
    } else if (name == "reversible steps") {
        gas.integrate_by<ReversibleSteps>(limit, dt);
        gas.limit_steps({});
    } else if (name == "naive steps") {  // the limit at the beginning of the step, as most codes do
        gas.integrate_by<KickDriftKick>();
        gas.limit_steps(limit);
    } else {
        throw std::invalid_argument{"no such integrator: " + name};
    }
}

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

using K = AnyKernel<1>;
/// h as in WithoutOmega, with the force (3.5).
struct NonConservingH : ConsistentH<K> {
    using ConsistentH<K>::ConsistentH;
    using Force = NonConservingForce;
};

double mean(const Column& m, const Column& value) {
    double sum = 0, mass = 0;
    for (std::size_t i = 0; i < m.size(); ++i) {
        sum += m[i] * value[i];
        mass += m[i];
    }
    return sum / mass;
}

/// A gas whose forces see their common centre: it must be known before they are computed.
template <class Resolution>
class Alone : public Gas<Resolution, Barotropic<Polytrope>, Free, MutualAttraction> {
    using Base = Gas<Resolution, Barotropic<Polytrope>, Free, MutualAttraction>;

  public:
    Alone(const StarScene& scene, const Resolution& resolution)
        : Base{scene.n, resolution, {scene.state()}, Free{}, scene.threads, MutualAttraction{1, &centre_}} {}
    void rates(double t) override {
        centre_ = mean(this->particles.m, this->particles.x[0]);
        Base::rates(t);
    }

  private:
    double centre_ = 0;
};

/// The centre of mass over time; returns the largest momentum over mass times amplitude.
template <class Resolution>
double follow_centre(const StarScene& scene, const Resolution& resolution, double amplitude, double time,
                     Column& t_out, Column& centre_out) {
    Alone<Resolution> gas{scene, resolution};
    fill_star(gas, scene);
    auto& p = gas.particles;
    for (std::size_t i = 0; i < scene.n; ++i)
        p.v[0][i] = amplitude * exact::toy_star_velocity(scene.gamma, 3, p.x[0][i]);
    const double drift = mean(p.m, p.v[0]);
    for (double& v : p.v[0]) v -= drift;
    gas.rates(0);
    const double dt = star_step(gas, scene, 0.3);
    gas.limit_steps([dt] { return dt; });
    const auto steps = static_cast<long>(std::ceil(time / dt));
    double t = 0, largest = 0;
    long k = 0;
    march(gas, t, {.steps = steps}, [&](double now) {
        largest = std::max(largest, std::abs(mean(p.m, p.v[0])) / amplitude);
        if (k++ % std::max(1L, steps / 400) != 0) return;
        t_out.push_back(now);
        centre_out.push_back(mean(p.m, p.x[0]));
    });
    return largest;
}

}  // namespace

EnergyHistory run_star_energy(const StarScene& scene, const std::string& name, double A_0, double courant,
                              long steps, const std::string& kernel) {
    const auto gas = star_gas(scene, {"consistent-h", kernel, 1.2});
    relax(*gas);
    const double period = scene.exact(A_0).period();
    EnergyHistory history;
    history.dt = star_step(*gas, scene, courant);
    history.steps = steps;
    integrate_by_name(*gas, name, [&] { return star_step(*gas, scene, courant); });
    for (std::size_t i = 0; i < scene.n; ++i) gas->get<Velocity>()[0][i] = A_0 * gas->get<Position>()[0][i];
    gas->rates(0);
    const Totals<1> start = gas->totals();
    // Only kick-drift-kick leaves the density of the end, which the energy wants.
    const bool resolved = name == "kick-drift-kick" || name == "naive steps";
    MeanDrift drift{period};
    ShadowHamiltonian shadow{history.dt};
    Range energies, shadows;
    energies.add(0);
    double t = 0;
    long k = 0;
    march(*gas, t, {.steps = steps}, [&](double now) {
        if (!resolved) gas->resolve(now);
        const Totals<1> totals = gas->totals();
        const double change = totals.energy / start.energy - 1;
        drift.add(now, change);
        if (now < period) {
            energies.add(change);
            if (const auto H = shadow.next(*gas, totals.energy)) shadows.add(*H / start.energy - 1);
        }
        history.momentum = std::max(history.momentum, std::abs(totals.momentum[0]) / (start.mass * A_0));
        if (++k % std::max(1L, steps / 500) != 0) return;
        history.t.push_back(now);
        history.change.push_back(change);
    });
    history.amplitude = energies.half();
    if (name == "kick-drift-kick") history.shadow = shadows.half();
    history.drift = drift.total();
    return history;
}

CentreRun run_centres(const StarScene& scene, double amplitude, double time) {
    const K cubic{"cubic"};
    CentreRun run;
    run.conserving_momentum = follow_centre(scene, ConsistentH<K>{HRule{1.2}, 1e-12, cubic}, amplitude, time,
                                            run.conserving_t, run.conserving_centre);
    run.momentum =
        follow_centre(scene, NonConservingH{HRule{1.2}, 1e-12, cubic}, amplitude, time, run.t, run.centre);
    return run;
}

}  // namespace sph::euler
