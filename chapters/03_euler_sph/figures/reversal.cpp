#include "chapters/03_euler_sph/scenes/reversal.hpp"

#include <map>

#include "common/plot/looks.hpp"

/// A wave run forward and back: how far each integrator comes back from.
namespace sph::euler {
namespace {

struct Drawn {
    std::string name;
    std::size_t colour;
    plot::Marker marker;
};
const std::vector<Drawn>& drawn() {
    static const std::vector<Drawn> all{{"naive steps", 1, plot::Marker::square},
                                        {"RK4", 2, plot::Marker::triangle_up},
                                        {"reversible steps", 3, plot::Marker::diamond},
                                        {"kick-drift-kick", 0, plot::Marker::circle}};
    return all;
}

/// |v + v(0)| of every second particle; what is exactly 0 has no place on a logarithmic axis.
void draw(plot::Panel& panel, const Drawn& look, const ReversalRun& back) {
    plot::Values x, missed;
    for (std::size_t i = 0; i < back.x.size(); i += 2) {
        const double miss = std::abs(back.v[i] + back.start_v[i]);
        if (miss == 0) continue;
        x.push_back(back.x[i]);
        missed.push_back(miss / 0.05);
    }
    panel.points(
        x, missed,
        {.label = look.name, .colour = plot::cycle(look.colour), .marker = look.marker, .marker_size = 4});
}

void claims(report::Run& run, const std::map<std::string, ReversalRun>& five) {
    run.claim("leapfrog-returns", [&] {
        bool all = five.at("fixed point").bitwise && five.at("fixed point").velocity_error == 0;
        for (const char* name : {"kick-drift-kick", "drift-kick-drift", "reversible steps"})
            all = all && five.at(name).velocity_error < 1e-11 && !five.at(name).bitwise;
        return all;
    });
    run.claim("others-do-not", [&] {
        return five.at("RK4").velocity_error > 1e-5 &&
               five.at("naive steps").velocity_error > 2 * five.at("RK4").velocity_error &&
               five.at("RK4").energy_drift < 0.1 * five.at("kick-drift-kick").energy_drift;
    });
    run.claim("return-is-not-accuracy", [&] {
        const auto off = [&](const char* name) { return five.at(name).energy_drift; };
        return off("kick-drift-kick") > 0.002 && off("reversible steps") > 0.002 &&
               std::abs(off("naive steps") / off("kick-drift-kick") - 1) < 0.2;
    });
}

}  // namespace

void reversal(report::Run& run) {
    plot::Figure figure{"reversal"};
    figure.panel_width = 560;
    plot::Panel& panel = figure.panel().log_y().labels("$x$", "| $v$ + $v$(0) | / amplitude");
    panel.x_range(0, 1).y_range(1e-15, 1e-2);
    panel.legend.outside = true;
    const int steps = run.quick() ? 200 : 2000;
    report::Table table{
        {"integrator", "1 wave: L2 of v + v(0)", "5 waves", "energy of 5 waves", "x returns bitwise"}};
    std::map<std::string, ReversalRun> one, five;
    for (const std::string& name : reversal_integrators()) {
        for (const int waves : {1, 5}) {
            const ReversalRun back = run_reversal(name, waves, steps);
            run.record(name + " waves=" + std::to_string(waves), 100,
                       {{"l2_v", back.velocity_error},
                        {"rms_x", back.position_error, "dx"},
                        {"energy_drift", back.energy_drift},
                        {"bitwise", back.bitwise ? 1.0 : 0.0}});
            (waves == 1 ? one : five)[name] = back;
        }
        // What is left below 1e-11 is amplified rounding, and depends on the machine.
        const auto text = [](const ReversalRun& back) {
            return back.bitwise                  ? std::string{"0"}
                   : back.velocity_error < 1e-11 ? std::string{"< 10⁻¹¹"}
                                                 : report::number(back.velocity_error, 1);
        };
        table.row({name, text(one[name]), text(five[name]), report::number(five[name].energy_drift, 1),
                   five[name].bitwise ? "yes" : "no"});
    }
    for (const Drawn& look : drawn()) draw(panel, look, five[look.name]);
    run.save(figure);
    run.fill("reversal", table.markdown());
    claims(run, five);
}

}  // namespace sph::euler
