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
    add("non-conserving", "sum (1.4)", "(3.2)", NonConservingForm<K>{{h, cubic}});
    add("summed", "sum (1.4)", "(3.7)", FixedH<K>{h, cubic});
    add("phi-density", "(3.9), Φ = ρ", "(3.7), Φ = ρ", ContinuityH<K, PhiIsDensity>{h, cubic});
    add("phi-one", "(3.10), Φ = 1", "(3.16), Φ = 1", ContinuityH<K, PhiIsOne>{h, cubic});
    add("phi-root-pressure", "(3.11), Φ = √$P$", "(3.17), Φ = √$P$",
        ContinuityH<K, PhiIsRootPressure>{h, cubic});
    add("mixed-one-density", "(3.9), Φ = ρ", "(3.16), Φ = 1",
        MixedForm<K, PhiIsOne, PhiIsDensity>{{h, cubic}});
    add("mixed-density-one", "(3.10), Φ = 1", "(3.7), Φ = ρ",
        MixedForm<K, PhiIsDensity, PhiIsOne>{{h, cubic}});
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

EnergyRun run_energies(EnergyForm form, double courant, std::size_t per_side, double time,
                       std::uint64_t seed) {
    using P = Particles<2, Position, Velocity, Acceleration, Mass, Density, Pressure, ThermalEnergy, Heating,
                        ThermokineticEnergy, ThermokineticRate>;
    P p{per_side * per_side};
    set_wave(p, per_side, seed);
    const IdealGas state{gamma_};
    const auto kinetic = [&](std::size_t i) { return 0.5 * (square(p.v[0][i]) + square(p.v[1][i])); };
    double motion = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.u[i] = 1 / (gamma_ * (gamma_ - 1));
        p.e[i] = p.u[i] + kinetic(i);
        motion += p.m[i] * kinetic(i);
    }
    const double h = h_over_dx / static_cast<double>(per_side);
    const ConstantH<K> smoothing{h, cubic};
    Neighbours<2, Box<2>> neighbours{periodic_unit_box<2>()};
    const bool from_e = form == EnergyForm::thermokinetic;
    const auto resolve = [&] {
        neighbours.find(p.x, smoothing.reach());
        sum_over_neighbours(p, neighbours, smoothing, Effects{SummedDensity{}});
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (from_e) p.u[i] = p.e[i] - kinetic(i);
            p.p[i] = state.pressure(p.rho[i], p.u[i]);
        }
    };
    const auto rates = [&](double) {
        resolve();
        if (form == EnergyForm::own)
            sum_over_neighbours(p, neighbours, smoothing, Effects{PressureForce<>{}, CompressionHeating<>{}});
        else
            sum_over_neighbours(p, neighbours, smoothing,
                                Effects{PressureForce<>{}, SharedHeating{}, Work{}});
    };
    const auto total = [&] {
        double sum = 0;
        for (std::size_t i = 0; i < p.size(); ++i) sum += p.m[i] * (p.u[i] + kinetic(i));
        return sum;
    };
    resolve();
    const double start = total();
    Column entropy;
    for (std::size_t i = 0; i < p.size(); ++i) entropy.push_back(p.p[i] / std::pow(p.rho[i], gamma_));
    Motion motions{neighbours.team()};
    motions.evolve<Position, Velocity>(p).evolve<Velocity, Acceleration>(p);
    if (from_e)
        motions.evolve<ThermokineticEnergy, ThermokineticRate>(p);
    else
        motions.evolve<ThermalEnergy, Heating>(p);
    motions.watch(p);
    RungeKutta2 integrator{motions, rates};
    double t = 0;
    march(integrator, t, {.end = time, .steps = std::lround(std::ceil(time / (courant * h)))});
    resolve();
    double squares = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
        squares += square(p.p[i] / std::pow(p.rho[i], gamma_) / entropy[i] - 1);
    return {(total() - start) / motion, std::sqrt(squares / static_cast<double>(p.size()))};
}

}  // namespace sph::euler
