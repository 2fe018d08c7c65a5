#include "chapters/04_artificial_viscosity/scenes/tube_report.hpp"

#include "common/app/error.hpp"

namespace sph {
namespace {

void draw(report::Run& run, const TubeRun& tube, const Profile& line) {
    plot::Figure figure{"tube", 2, 2};
    const auto panel = [&](int row, int column, const std::string& label, const Column& value,
                           const Column& exact) {
        plot::Panel& axes = figure.at(row, column).labels("$x$", label);
        axes.curve(line.x, exact, {.label = "exact", .colour = plot::Colour{0, 0, 0}});
        axes.points(tube.profile.x, value,
                    {.label = "SPH", .marker = plot::Marker::circle, .marker_size = 3});
    };
    panel(0, 0, "ρ", tube.profile.rho, line.rho);
    panel(0, 1, "$v$", tube.profile.v, line.v);
    panel(1, 0, "$P$", tube.profile.p, line.p);
    panel(1, 1, "$u$", tube.profile.u, line.u);
    run.save(figure);
}

}  // namespace

exact::Riemann::State tube_state(const std::string& option, const std::vector<double>& values) {
    const exact::Riemann::State state{values[0], values[1], values[2]};
    if (state.rho < 0 || state.p < 0)
        throw app::UsageError{"--" + option +
                              ": density or pressure below 0 is not allowed; allowed: 0 and above"};
    if ((state.rho == 0) != (state.p == 0))
        throw app::UsageError{
            "--" + option +
            ": only one of density and pressure is 0, which is not allowed; allowed: both (a "
            "vacuum) or none"};
    return state;
}

const Method& choose_method(const std::string& name, const std::vector<Method>& methods) {
    if (name.empty()) return methods.back();
    std::string allowed;
    for (const Method& method : methods) {
        if (method.name == name) return method;
        allowed += ", " + method.name;
    }
    throw app::UsageError{"--method: " + name + " is not allowed; allowed: list" + allowed};
}

std::string method_list(const std::vector<Method>& methods) {
    std::string names;
    for (const Method& method : methods)
        names += method.name + (&method == &methods.back() ? " (recommended)\n" : "\n");
    return names;
}

void report_tube(report::Run& run, const std::string& method, long n, const TubeRun& tube,
                 const Profile& line) {
    const auto row = [&](const std::string& quantity, double value) {
        run.result(method, n, quantity, value);
    };
    row("l1_rho", tube.l1_rho);
    row("l1_v", tube.l1_v);
    row("l1_p", tube.l1_p);
    row("l1_u", tube.l1_u);
    row("overshoot_rho", tube.overshoot);
    row("wiggle_p", tube.wiggle);
    row("energy_drift", tube.energy_drift);
    row("momentum_drift", tube.momentum_drift);
    row("steps", static_cast<double>(tube.counters.steps));
    row("pairs", static_cast<double>(tube.counters.pairs));
    run.result(method, n, "cpu_seconds", tube.seconds, "s");
    std::string csv = "x,rho,v,p,u,exact_rho,exact_v,exact_p,exact_u\n";
    for (std::size_t i = 0; i < tube.profile.x.size(); ++i)
        csv += report::csv_row({tube.profile.x[i], tube.profile.rho[i], tube.profile.v[i], tube.profile.p[i],
                                tube.profile.u[i], tube.exact.rho[i], tube.exact.v[i], tube.exact.p[i],
                                tube.exact.u[i]});
    run.write("profile.csv", csv);
    draw(run, tube, line);
}

}  // namespace sph
