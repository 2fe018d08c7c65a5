#include "chapters/03_euler_sph/scenes/star_energy.hpp"
#include "common/report/norms.hpp"

namespace sph::euler {

void energy(report::Run& run) {
    plot::Figure figure{"energy", 1, 2};
    plot::Panel& left =
        figure.at(0, 0).titled("star of 100, $v$(0) = 0.3 Ω$x$").labels("Ω$t$", "10^{6} Δ$E$ / $E$");
    plot::Panel& right = figure.at(0, 1)
                             .log_log()
                             .titled("amplitude over a period, and drift")
                             .labels("time step [least spacing/$c_{s}$]", "Δ$E$ / $E$");
    StarScene scene;
    scene.n = 100;
    scene.threads = run.threads();
    const Column courants = run.quick() ? Column{0.2, 0.4} : Column{0.2, 0.4, 0.8};
    report::Table table{{"integrator", "Δt = 0.4: amplitude", "drift", "Δt = 0.2: amplitude", "drift"}};
    std::size_t index = 0;
    for (const std::string& name : star_integrators()) {
        plot::Values amplitude, drift;
        std::vector<std::string> row{name};
        for (const double courant : courants) {
            const auto steps = static_cast<long>((run.quick() ? 400 : 1000) / courant);
            const EnergyHistory history = run_star_energy(scene, name, 0.3, courant, steps);
            amplitude.push_back(history.amplitude);
            drift.push_back(std::max(1e-16, std::abs(history.drift)));
            const std::string method = name + " courant=" + report::number(courant, 2);
            run.record(method, 100,
                       {{"energy_amplitude", history.amplitude}, {"energy_drift", history.drift}});
            if (courant == 0.4 && name != "drift-kick-drift") {
                plot::Values change;
                for (const double value : history.change) change.push_back(1e6 * value);
                left.curve(history.t, change, {.label = name, .colour = plot::cycle(index), .width = 1});
            }
        }
        constexpr std::size_t coarse = 1, fine = 0;
        for (const std::size_t k : {coarse, fine}) {
            row.push_back(report::number(amplitude[k], 1));
            row.push_back(drift[k] < 1e-8 ? "< 10⁻⁸" : report::number(drift[k], 1));
        }
        table.row(row);
        right.curve(courants, amplitude,
                    {.label = name, .colour = plot::cycle(index), .marker = plot::Marker::circle});
        if (name == "RK4" || name == "naive steps")
            right.curve(courants, drift,
                        {.label = name + ", drift",
                         .colour = plot::cycle(index),
                         .dash = plot::Dash::dashed,
                         .marker = plot::Marker::square});
        if (name == "kick-drift-kick") {
            const double order = -report::fitted_order(courants, amplitude);
            run.record(name, 100, {{"rate_energy_amplitude", order}});
            run.fill("energy-order", report::fixed(order, 2));
        }
        ++index;
    }
    right.legend.outside = true;
    left.legend.shown = false;
    run.save(figure);
    run.fill("energy", table.markdown());
    // As long as the seconds allow: a star of 400 over a hundred thousand steps.
    scene.n = run.quick() ? 100 : 400;
    const long steps = run.quick() ? 5000 : 100000;
    const EnergyHistory longest = run_star_energy(scene, "kick-drift-kick", 0.3, 0.3, steps);
    run.record("kick-drift-kick long", scene.n,
               {{"energy_amplitude", longest.amplitude},
                {"energy_drift", longest.drift},
                {"momentum_drift", longest.momentum},
                {"steps", static_cast<double>(longest.steps)}});
    run.fill("energy-long-amplitude", report::number(longest.amplitude, 1));
    run.fill("energy-long-drift",
             std::abs(longest.drift) < 1e-10 ? "less than 10⁻¹⁰" : report::number(longest.drift, 1));
}

}  // namespace sph::euler
