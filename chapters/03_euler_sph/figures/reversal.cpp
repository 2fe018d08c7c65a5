#include "chapters/03_euler_sph/scenes/reversal.hpp"
#include "common/plot/looks.hpp"

namespace sph::euler {

void reversal(report::Run& run) {
    plot::Figure figure{"reversal", 1, 2};
    figure.panel_width = 330;
    const int steps = run.quick() ? 200 : 2000;
    report::Table table{
        {"integrator", "1 wave: L2 of v + v(0)", "5 waves", "energy of 5 waves", "x returns bitwise"}};
    std::vector<std::vector<std::string>> rows;
    for (const auto& [waves, column] : {std::pair{1, 0}, {5, 1}}) {
        plot::Panel& panel = figure.at(0, column)
                                 .titled(waves == 1 ? "figure 8: $v$(0) = 0.05 $c_{s}$ sin 2π$x$"
                                                    : "figure 9: $v$(0) = 0.05 $c_{s}$ sin 10π$x$")
                                 .labels("$x$", column == 0 ? "$v$ / $c_{s}$ at step 4000" : "");
        plot::draw_exact(panel, 0, 1,
                         [waves = waves](double x) { return -0.05 * std::sin(2 * pi * waves * x); });
        std::size_t row = 0;
        for (const std::string& name : reversal_integrators()) {
            const ReversalRun back = run_reversal(name, waves, steps);
            const std::string method = name + " waves=" + std::to_string(waves);
            run.record(method, 100,
                       {{"l2_v", back.velocity_error},
                        {"rms_x", back.position_error, "dx"},
                        {"energy_drift", back.energy_drift},
                        {"bitwise", back.bitwise ? 1.0 : 0.0}});
            if (name == "kick-drift-kick")
                panel.points(back.x, back.v,
                             {.label = "kick-drift-kick",
                              .colour = plot::cycle(0),
                              .marker = plot::Marker::circle,
                              .marker_size = 4});
            // What is left below 1e-11 is amplified rounding, and depends on the machine.
            const std::string error = back.bitwise                  ? "0"
                                      : back.velocity_error < 1e-11 ? "< 10⁻¹¹"
                                                                    : report::number(back.velocity_error, 1);
            if (waves == 1) {
                rows.push_back({name, error});
            } else {
                rows[row].push_back(error);
                rows[row].push_back(report::number(back.energy_drift, 1));
                rows[row].push_back(back.bitwise ? "yes" : "no");
            }
            ++row;
        }
        panel.legend.shown = column == 1;
        panel.legend.outside = true;
    }
    for (const auto& row : rows) table.row(row);
    run.save(figure);
    run.fill("reversal", table.markdown());
}

}  // namespace sph::euler
