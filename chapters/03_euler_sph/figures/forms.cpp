#include "chapters/03_euler_sph/scenes/forms.hpp"
#include "common/report/chapter.hpp"

namespace sph::euler {
namespace {

/// The density equations on a line of particles, as a table.
void density_table(report::Run& run) {
    report::Table table{{"particle", "v", "dρ/dt, exact", "ρ (164)", "ρ (165)", "dρ/dt (166)",
                         "(167) = (2.17)", "(168) = (2.18)"}};
    for (const auto& [place, name] : {std::pair{OnLine::inside, std::string{"inside"}},
                                      {OnLine::end, "at the end"},
                                      {OnLine::light_side, "beside tenfold density"}}) {
        for (const bool expanding : {false, true}) {
            const DensityForms forms = density_forms(place, expanding);
            // Zero but for rounding is zero.
            const auto text = [](double value) {
                return report::fixed(std::abs(value) < 1e-10 ? 0 : value, 3);
            };
            table.row({name, expanding ? "x" : "1", expanding ? "-1" : "0", text(forms.summed),
                       text(forms.normalised), text(forms.plain), text(forms.differences),
                       text(forms.by_mass)});
        }
    }
    run.fill("density-forms", table.markdown());
}

}  // namespace

void forms(report::Run& run) {
    plot::Figure figure{"forms", 1, 2};
    plot::Panel& left = figure.at(0, 0)
                            .log_log()
                            .titled("density and force of one Φ, or not")
                            .labels("time step [$h$/$c_{s}$]", "change of energy / motion");
    const Column courants = run.quick() ? Column{0.15, 0.3} : Column{0.15, 0.2, 0.3, 0.4};
    const std::size_t per_side = run.quick() ? 12 : 24, particles = per_side * per_side;
    report::Table table{
        {"density", "force", "change of momentum", "of energy, dt = 0.3 h/c_s", "dt = 0.15 h/c_s"}};
    std::size_t index = 0;
    constexpr std::array markers{plot::Marker::cross,      plot::Marker::circle,        plot::Marker::square,
                                 plot::Marker::diamond,    plot::Marker::triangle_down, plot::Marker::plus,
                                 plot::Marker::triangle_up};
    for (const FormRun& form : run_forms(courants, per_side, 1, run.seed(), run.threads())) {
        plot::Values size;
        std::string coarse, fine;
        for (std::size_t k = 0; k < courants.size(); ++k) {
            size.push_back(std::abs(form.energy[k]));
            run.record(form.name + " courant=" + report::number(courants[k], 2), particles,
                       {{"energy_drift", form.energy[k]}});
            if (courants[k] == 0.3) coarse = report::number(form.energy[k], 1);
            if (courants[k] == 0.15) fine = report::number(form.energy[k], 1);
        }
        run.record(form.name, particles, {{"momentum_drift", form.momentum}});
        left.curve(courants, size,
                   {.label = form.density + " with " + form.force,
                    .colour = plot::cycle(index),
                    .marker = markers[index]});
        ++index;
        // Below 1e-13 it is rounding, and the text says so instead of a number that changes with the machine.
        table.row({form.density, form.force,
                   form.momentum < 1e-13 ? "rounding" : report::number(form.momentum, 1), coarse, fine});
    }
    left.legend.shown = true;
    left.legend.outside = true;
    plot::Panel& right = figure.at(0, 1)
                             .log_log()
                             .titled("thermal or thermokinetic energy, RK2")
                             .labels("time step [$h$/$c_{s}$]", "change of energy / motion");
    plot::Values thermal, floor;
    for (const double courant : courants) {
        const EnergyRun energies = run_energies(courant, per_side, 1, run.seed());
        thermal.push_back(std::abs(energies.thermal));
        floor.push_back(std::max(1e-16, std::abs(energies.thermokinetic)));
        const std::string at = " courant=" + report::number(courant, 2);
        run.record("thermal" + at, particles, {{"energy_drift", energies.thermal}});
        run.record("thermokinetic" + at, particles, {{"energy_drift", energies.thermokinetic}});
    }
    right.curve(courants, thermal, {.label = "$u$, (3.14)", .marker = plot::Marker::circle});
    right.curve(courants, floor, {.label = "$e$, (3.18)", .marker = plot::Marker::square});
    run.save(figure);
    run.fill("forms", table.markdown());
    density_table(run);
}

}  // namespace sph::euler
