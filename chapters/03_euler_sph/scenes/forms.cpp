#include "chapters/03_euler_sph/scenes/forms.hpp"

namespace sph::euler {
namespace {

using K = AnyKernel<2>;
const K cubic{"cubic"};
constexpr double mach = 0.3, gamma_ = 1.4, h_over_dx = 1.3;

/// rho = 1, c_s = 1, v along x and y in waves of the box.
template <class P>
void set_wave(P& p, std::size_t per_side, std::uint64_t seed) {
    p.x = make_points<2>(Arrangement::jittered, per_side, 0.2, seed);
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.m[i] = 1 / static_cast<double>(p.size());
        p.rho[i] = 1;
        p.v[0][i] = mach * std::sin(2 * pi * p.x[0][i]);
        p.v[1][i] = mach * std::sin(2 * pi * p.x[1][i]);
    }
}

struct FormDrift {
    double momentum, energy;
};

template <class Form>
FormDrift run(const Form& form, std::size_t per_side, double time, std::uint64_t seed, int threads,
              double courant) {
    Gas<Form, Barotropic<Polytrope>, Box<2>> gas{
        per_side * per_side, form, {{1 / gamma_, gamma_}}, periodic_unit_box<2>(), threads};
    set_wave(gas.particles, per_side, seed);
    gas.resolve(0);
    double speed = 0, motion = 0;
    for (std::size_t i = 0; i < gas.particles.size(); ++i) {
        const double v2 = square(gas.particles.v[0][i]) + square(gas.particles.v[1][i]);
        speed += gas.particles.m[i] * std::sqrt(v2);
        motion += gas.particles.m[i] * v2 / 2;
    }
    Drifts drifts{gas};
    gas.template integrate_by<RungeKutta4>();
    double t = 0;
    march(gas, t, {.end = time, .steps = std::lround(std::ceil(time / (courant * form.h)))},
          [&](double) { drifts.look(); });
    gas.resolve(t);
    return {drifts.momentum() / speed, (gas.totals().energy - drifts.first().energy) / motion};
}

}  // namespace

std::vector<FormRun> run_forms(const Column& courants, std::size_t per_side, double time, std::uint64_t seed,
                               int threads) {
    const double h = h_over_dx / static_cast<double>(per_side);
    std::vector<FormRun> runs;
    const auto add = [&](const std::string& name, const std::string& density, const std::string& force,
                         const auto& form) {
        FormRun all{name, density, force, 0, courants, {}};
        for (const double courant : courants) {
            const FormDrift drift = run(form, per_side, time, seed, threads, courant);
            all.momentum = std::max(all.momentum, drift.momentum);
            all.energy.push_back(drift.energy);
        }
        runs.push_back(all);
    };
    add("non-conserving", "summed (2.9)", "(3.5)", NonConservingForm<K>{{h, cubic}});
    add("summed", "summed (2.9)", "(3.8)", FixedH<K>{h, cubic});
    add("phi-density", "(2.18)", "(3.8), Φ = ρ", ContinuityH<K, PhiIsDensity>{h, cubic});
    add("phi-one", "(2.17)", "(5.32), Φ = 1", ContinuityH<K, PhiIsOne>{h, cubic});
    add("phi-root-pressure", "Φ = √$P$", "(5.36), Φ = √$P$", ContinuityH<K, PhiIsRootPressure>{h, cubic});
    add("mixed-one-density", "(2.18)", "(5.32), Φ = 1", MixedForm<K, PhiIsOne, PhiIsDensity>{{h, cubic}});
    add("mixed-density-one", "(2.17)", "(3.8), Φ = ρ", MixedForm<K, PhiIsDensity, PhiIsOne>{{h, cubic}});
    return runs;
}

DensityForms density_forms(OnLine place, bool expanding) {
    constexpr std::size_t n = 41;
    constexpr double dx = 1.0 / n;
    Particles<1, Position, Velocity, Mass, Density, Volume, NormalisedDensity, PlainContinuity> p{n};
    for (std::size_t i = 0; i < n; ++i) {
        p.x[0][i] = dx * static_cast<double>(i);
        p.v[0][i] = expanding ? p.x[0][i] : 1;
        p.rho[i] = place == OnLine::light_side && i > n / 2 ? 10 : 1;
        p.m[i] = p.rho[i] * dx;
        p.V[i] = dx;
    }
    const std::size_t i = place == OnLine::end ? n - 1 : n / 2;
    Neighbours<1> neighbours;
    const ConstantH<AnyKernel<1>> smoothing{1.2 * dx, AnyKernel<1>{"cubic"}};
    neighbours.find(p.x, smoothing.reach());
    const auto rate_of = [&](const auto& continuity) {
        Particles<1, Position, Velocity, Mass, Density, DensityRate> q{n};
        q.x = p.x;
        q.v = p.v;
        q.m = p.m;
        q.rho = p.rho;
        sum_over_neighbours(q, neighbours, smoothing, Effects{continuity});
        return q.drho_dt[i];
    };
    DensityForms forms;
    forms.differences = rate_of(Continuity<PhiIsOne>{});
    forms.by_mass = rate_of(Continuity<PhiIsDensity>{});
    sum_over_neighbours(p, neighbours, smoothing, Effects{PlainContinuity{}, NormalisedDensity{}});
    forms.plain = p.plain_drho_dt[i];
    forms.normalised = p.normalised[i];
    sum_over_neighbours(p, neighbours, smoothing, Effects{SummedDensity{}});
    forms.summed = p.rho[i];
    return forms;
}

EnergyRun run_energies(double courant, std::size_t per_side, double time, std::uint64_t seed) {
    using P = Particles<2, Position, Velocity, Acceleration, Mass, Density, Pressure, ThermalEnergy, Heating,
                        ThermokineticEnergy, ThermokineticRate>;
    P p{per_side * per_side};
    set_wave(p, per_side, seed);
    const IdealGas state{gamma_};
    double motion = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.u[i] = 1 / (gamma_ * (gamma_ - 1));
        const double kinetic = 0.5 * (square(p.v[0][i]) + square(p.v[1][i]));
        p.e[i] = p.u[i] + kinetic;
        motion += p.m[i] * kinetic;
    }
    const double h = h_over_dx / static_cast<double>(per_side);
    const ConstantH<K> smoothing{h, cubic};
    Neighbours<2, Box<2>> neighbours{periodic_unit_box<2>()};
    const auto rates = [&](double) {
        neighbours.find(p.x, smoothing.reach());
        sum_over_neighbours(p, neighbours, smoothing, Effects{SummedDensity{}});
        for (std::size_t i = 0; i < p.size(); ++i) p.p[i] = state.pressure(p.rho[i], p.u[i]);
        sum_over_neighbours(p, neighbours, smoothing,
                            Effects{PressureForce<>{}, CompressionHeating<>{}, Work{}});
    };
    const auto totals = [&] {
        std::array<double, 2> sum{};
        for (std::size_t i = 0; i < p.size(); ++i) {
            sum[0] += p.m[i] * (p.u[i] + 0.5 * (square(p.v[0][i]) + square(p.v[1][i])));
            sum[1] += p.m[i] * p.e[i];
        }
        return sum;
    };
    const auto start = totals();
    Motion motions{neighbours.team()};
    motions.evolve<Position, Velocity>(p)
        .evolve<Velocity, Acceleration>(p)
        .evolve<ThermalEnergy, Heating>(p)
        .evolve<ThermokineticEnergy, ThermokineticRate>(p)
        .watch(p);
    RungeKutta2 integrator{motions, rates};
    double t = 0;
    march(integrator, t, {.end = time, .steps = std::lround(std::ceil(time / (courant * h)))});
    const auto end = totals();
    return {(end[0] - start[0]) / motion, (end[1] - start[1]) / motion};
}

}  // namespace sph::euler
