#include "chapters/03_euler_sph/scenes/forms.hpp"

#include <algorithm>

#include "common/report/chapter.hpp"
#include "common/report/norms.hpp"

/// What each form of density, force and energy conserves.
namespace sph::euler {
namespace {

/// The density equations on a line of particles, as a table.
void density_table(report::Run& run) {
    report::Table table{
        {"particle", "v", "dρ/dt, exact", "(3.9)", "(3.10)", "(3.12)", "ρ by the sum", "ρ by (3.13)"}};
    bool differences_see_no_motion = true, half_is_lost = false, mass_is_not_volume = false;
    for (const auto& [place, name] : {std::pair{OnLine::inside, std::string{"inside"}},
                                      {OnLine::end, "at the end"},
                                      {OnLine::light_side, "beside tenfold ρ"}}) {
        for (const bool expanding : {false, true}) {
            const DensityForms forms = density_forms(place, expanding);
            // Zero but for rounding is zero.
            const auto text = [](double value) {
                return report::fixed(std::abs(value) < 1e-10 ? 0 : value, 3);
            };
            table.row({name, expanding ? "x" : "1", expanding ? "-1" : "0", text(forms.by_mass),
                       text(forms.differences), text(forms.plain), text(forms.summed),
                       text(forms.normalised)});
            if (!expanding)
                differences_see_no_motion = differences_see_no_motion && std::abs(forms.by_mass) < 1e-10 &&
                                            std::abs(forms.differences) < 1e-10;
            if (place == OnLine::end && !expanding)
                half_is_lost = std::abs(forms.plain) > 10 && forms.summed < 0.8 &&
                               std::abs(forms.normalised - 1) < 1e-10;
            if (place == OnLine::light_side && expanding)
                mass_is_not_volume = forms.by_mass < -5 && std::abs(forms.differences + 1) < 0.03 &&
                                     forms.summed > 3 && forms.normalised > 3;
        }
    }
    run.fill("density-forms", table.markdown());
    run.claim("plain-is-wrong-at-ends", [&] { return differences_see_no_motion && half_is_lost; });
    run.claim("mass-for-volume", [&] { return mass_is_not_volume; });
}

struct Drawn {
    std::string label;
    std::size_t colour;
    plot::Marker marker;
};
/// Pairs of one Phi lie on one another: one of them stands for them.
Drawn look_of_form(const std::string& name) {
    using plot::Marker;
    if (name == "non-conserving") return {"(3.2)", 1, Marker::square};
    if (name == "summed") return {"sum with (3.7)", 5, Marker::plus};
    if (name == "phi-one") return {"one Φ", 0, Marker::circle};
    if (name == "mixed-one-density") return {"(3.9) with (3.16)", 2, Marker::triangle_down};
    if (name == "mixed-density-one") return {"(3.10) with (3.7)", 3, Marker::triangle_up};
    return {"", 0, Marker::none};
}

using Forms = std::vector<FormRun>;
const FormRun& form_of(const Forms& forms, const std::string& name) {
    return *std::find_if(forms.begin(), forms.end(), [&](const FormRun& form) { return form.name == name; });
}

void claims(report::Run& run, const Forms& forms, const Column& courants) {
    run.claim("momentum-antisymmetric", [&] {
        return std::all_of(forms.begin(), forms.end(), [](const FormRun& form) {
            return form.name == "non-conserving" ? form.momentum > 1e-3 : form.momentum < 1e-13;
        });
    });
    const auto order = [&](const FormRun& form) {
        plot::Values size;
        for (const double energy : form.energy) size.push_back(std::abs(energy));
        return -report::fitted_order(courants, size);
    };
    run.claim("one-phi", [&] {
        bool all = true;
        for (const char* name : {"summed", "phi-density", "phi-one", "phi-root-pressure"})
            all = all && order(form_of(forms, name)) > 4;
        return all;
    });
    run.claim("mixed-never", [&] {
        bool all = true;
        for (const char* name : {"mixed-one-density", "mixed-density-one"})
            all = all && std::abs(form_of(forms, name).energy[0]) > 0.01 &&
                  std::abs(order(form_of(forms, name))) < 0.3;
        return all;
    });
}

/// Density and force: energy against the time step.
void density_and_force(report::Run& run, plot::Panel& panel, const Column& courants, std::size_t per_side) {
    report::Table table{
        {"density", "force", "change of momentum", "of energy, Δt = 0.3 h/c_s", "Δt = 0.15 h/c_s"}};
    const Forms forms = run_forms(courants, per_side, 1, run.seed(), run.threads());
    for (const FormRun& form : forms) {
        plot::Values size;
        std::string coarse, fine;
        for (std::size_t k = 0; k < courants.size(); ++k) {
            size.push_back(std::abs(form.energy[k]));
            run.record(form.name + " courant=" + report::number(courants[k], 2), per_side * per_side,
                       {{"energy_drift", form.energy[k]}});
            if (courants[k] == 0.3) coarse = report::number(form.energy[k], 1);
            if (courants[k] == 0.15) fine = report::number(form.energy[k], 1);
        }
        run.record(form.name, per_side * per_side, {{"momentum_drift", form.momentum}});
        const Drawn drawn = look_of_form(form.name);
        if (!drawn.label.empty())
            panel.curve(courants, size,
                        {.label = drawn.label, .colour = plot::cycle(drawn.colour), .marker = drawn.marker});
        // Below 1e-13 it is rounding, and the text says so instead of a number that changes with the machine.
        table.row({form.density, form.force,
                   form.momentum < 1e-13 ? "rounding" : report::number(form.momentum, 1), coarse, fine});
    }
    run.fill("forms", table.markdown());
    claims(run, forms, courants);
}

/// Energy equations: what they make of energy and entropy.
void energies(report::Run& run, plot::Panel& panel, const Column& courants, std::size_t per_side) {
    report::Table table{{"energy equation", "energy, Δt = 0.3 h/c_s", "Δt = 0.15 h/c_s",
                         "entropy, Δt = 0.3 h/c_s", "Δt = 0.15 h/c_s"}};
    struct Line {
        EnergyForm form;
        std::string name, label;
        plot::Marker marker;
        std::vector<EnergyRun> runs{};
    };
    std::vector<Line> lines{
        {EnergyForm::own, "thermal", "own (3.18)", plot::Marker::circle},
        {EnergyForm::shared, "thermal shared", "shared (3.19)", plot::Marker::square},
        {EnergyForm::thermokinetic, "thermokinetic", "thermokinetic (3.20)", plot::Marker::diamond}};
    for (Line& line : lines) {
        plot::Values entropy;
        std::vector<std::string> row{line.label};
        for (const double courant : courants) {
            const EnergyRun energy = run_energies(line.form, courant, per_side, 1, run.seed());
            line.runs.push_back(energy);
            entropy.push_back(energy.entropy);
            run.record(line.name + " courant=" + report::number(courant, 2), per_side * per_side,
                       {{"energy_drift", energy.energy}, {"entropy_change", energy.entropy}});
        }
        panel.curve(courants, entropy, {.label = line.label, .marker = line.marker});
        const std::size_t coarse = courants.size() > 2 ? 2 : 1, fine = 0;
        for (const std::size_t k : {coarse, fine})
            row.push_back(std::abs(line.runs[k].energy) < 1e-10 ? "rounding"
                                                                : report::number(line.runs[k].energy, 1));
        for (const std::size_t k : {coarse, fine}) row.push_back(report::number(line.runs[k].entropy, 1));
        table.row(row);
    }
    run.fill("energies", table.markdown());
    run.claim("thermokinetic-total", [&] {
        return std::all_of(lines[2].runs.begin(), lines[2].runs.end(),
                           [](const EnergyRun& one) { return std::abs(one.energy) < 1e-11; }) &&
               std::abs(lines[0].runs[0].energy) > 1e-3;
    });
    run.claim("shared-entropy", [&] {
        const auto &own = lines[0].runs, &shared = lines[1].runs;
        return own[0].entropy < own[2].entropy / 4 && shared[0].entropy > 10 * own[0].entropy &&
               std::abs(shared[0].entropy / shared[2].entropy - 1) < 0.2;
    });
}

}  // namespace

void forms(report::Run& run) {
    plot::Figure figure{"forms", 1, 2};
    figure.panel_width = 330;
    plot::Panel& left = figure.at(0, 0)
                            .log_log()
                            .titled("density with force")
                            .labels("Δ$t$ [$h$/$c_{s}$]", "change of energy / motion");
    plot::Panel& right = figure.at(0, 1)
                             .log_log()
                             .titled("energy equations")
                             .labels("Δ$t$ [$h$/$c_{s}$]", "rms change of $P$/ρ^{γ}, relative");
    for (plot::Panel* panel : {&left, &right}) {
        panel->x.ticks = {0.15, 0.2, 0.3, 0.4};
        panel->x_range(0.14, 0.43);
    }
    left.y_range(1e-6, 1);
    const Column courants = run.quick() ? Column{0.15, 0.3} : Column{0.15, 0.2, 0.3, 0.4};
    const std::size_t per_side = run.quick() ? 12 : 24;
    density_and_force(run, left, courants, per_side);
    energies(run, right, courants, per_side);
    left.slope(5, 0.2, 0.3, 5e-6, "order 5");
    run.save(figure);
    density_table(run);
}

}  // namespace sph::euler
