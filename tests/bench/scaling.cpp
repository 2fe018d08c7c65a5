#include <cmath>
#include <cstdlib>

#include "common/core/integrators.hpp"
#include "tests/bench/benches.hpp"
#include "tests/bench/gas.hpp"
#include "tests/bench/race.hpp"

/// Whole time steps of a gas in 3D: neighbours, density, equation of state, forces, integration.
namespace bench {
namespace {

/// 58 neighbours in the mean, the particle itself included.
constexpr double h_over_dx = 1.185;

class Stepper {
  public:
    Stepper(std::size_t per_side, int threads)
        : gas_{per_side, h_over_dx, threads},
          motion_{gas_.neighbours.team()},
          leapfrog_{motion_, [this](double) { rates(); }} {
        motion_.evolve<sph::Position, sph::Velocity>(gas_.particles)
            .evolve<sph::Velocity, sph::Acceleration>(gas_.particles)
            .evolve<sph::ThermalEnergy, sph::Heating>(gas_.particles);
    }

    void find() { gas_.find(); }
    void density() { gas_.sum(sph::Effects{sph::SummedDensity{}}); }
    void forces() { gas_.sum(sph::Effects{PressureForce{}, PressureHeating{}, ArtificialViscosity{}}); }
    void equation_of_state() {
        auto& p = gas_.particles;
        gas_.neighbours.team().parallel_for(p.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                p.p[i] = (gamma - 1) * p.rho[i] * p.u[i];
                p.c_s[i] = std::sqrt(gamma * p.p[i] / p.rho[i]);
            }
        });
    }
    void rates() {
        find();
        density();
        equation_of_state();
        forces();
    }
    /// A tenth of the largest stable step: nothing moves far while the bench repeats it.
    void step() { leapfrog_.step(t_, 0.03 * gas_.smoothing.h); }
    const Gas<3>& gas() const { return gas_; }

  private:
    static constexpr double gamma = 5.0 / 3;
    Gas<3> gas_;
    sph::Motion motion_;
    sph::KickDriftKick leapfrog_;
    double t_ = 0;
};

double load() {
    double average = 0;
    return getloadavg(&average, 1) == 1 ? average : 0;
}

/// Where the time of a step goes, at one size and on one thread.
void parts_of_a_step(report::Run& run, std::size_t per_side) {
    Stepper stepper{per_side, 1};
    stepper.step();
    const std::vector<Lap> laps = race(run, {{"neighbours", [&] { stepper.find(); }},
                                             {"density", [&] { stepper.density(); }},
                                             {"forces", [&] { stepper.forces(); }},
                                             {"step", [&] { stepper.step(); }}});
    const auto n = static_cast<double>(stepper.gas().particles.size());
    const double rest = laps[3].median - laps[0].median - laps[1].median - laps[2].median;
    report::Table table{{"part of a step", "ns a particle", "share"}};
    const auto row = [&](const std::string& name, double seconds) {
        table.row(
            {name, report::timing(1e9 * seconds / n), report::timing(100 * seconds / laps[3].median) + " %"});
        run.result(name, static_cast<long>(n), "ns_per_particle_step", 1e9 * seconds / n, "ns");
    };
    row("finding and listing neighbours", laps[0].median);
    row("density", laps[1].median);
    row("forces: pressure and viscosity with their heating", laps[2].median);
    row("equation of state and leapfrog", std::max(rest, 0.0));
    row("**the whole step**", laps[3].median);
    run.fill("bench-step", table.markdown());
}

}  // namespace

void scaling(report::Run& run) {
    const std::vector<std::size_t> sides =
        run.quick() ? std::vector<std::size_t>{10, 14} : std::vector<std::size_t>{10, 22, 46, 100};
    plot::Figure figure{"scaling"};
    plot::Panel& panel = figure.panel().titled("whole steps in 3D, 58 neighbours").log_x();
    panel.labels("particles", "million particle-steps a second");
    report::Table table{{"particles", "neighbours", "1 thread: 10⁶ particle-steps/s", "2 threads", "gain"}};
    std::vector<plot::Values> rate(2);
    plot::Values count;
    for (const std::size_t side : sides) {
        Stepper one{side, 1}, two{side, 2};
        const std::vector<Lap> laps =
            race(run, {{"1 thread", [&] { one.step(); }}, {"2 threads", [&] { two.step(); }}}, Clock::wall);
        const auto n = static_cast<double>(one.gas().particles.size());
        count.push_back(n);
        for (std::size_t k = 0; k < 2; ++k) {
            rate[k].push_back(1e-6 * n / laps[k].best);
            run.result(k == 0 ? "1 thread" : "2 threads", static_cast<long>(n), "particle_steps_per_second",
                       n / laps[k].best, "1/s");
        }
        run.result("2 threads", static_cast<long>(n), "gain", laps[0].best / laps[1].best);
        table.row({report::fixed(n, 0), report::fixed(one.gas().neighbours_each(), 0),
                   report::timing(rate[0].back()), report::timing(rate[1].back()),
                   report::timing(laps[0].best / laps[1].best, 3)});
    }
    run.result("machine", 1, "load_average", load());
    panel.curve(count, rate[0], {.label = "1 thread", .marker = plot::Marker::circle});
    panel.curve(count, rate[1], {.label = "2 threads", .marker = plot::Marker::square});
    panel.y_range(0, 1.2 * *std::max_element(rate[1].begin(), rate[1].end()));
    run.save(figure);
    run.fill("bench-scaling", table.markdown());
    run.fill("bench-load", report::timing(load()));
    parts_of_a_step(run, run.quick() ? 14 : 46);
}

}  // namespace bench
