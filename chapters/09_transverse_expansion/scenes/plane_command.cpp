#include "chapters/09_transverse_expansion/scenes/plane_command.hpp"

#include <cmath>

#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "common/exact/transverse.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"

namespace sph::transverse {
namespace {

void draw(report::Run& run, const Flow& flow, const Snapshot& shot, bool with_eps) {
    constexpr int points = 301;
    const FlowProfile exact = flow.exact(shot.time);
    double farthest = 0;
    for (const double r : shot.r) farthest = std::max(farthest, r);
    plot::Values r, first, u;
    for (int k = 0; k < points; ++k) {
        r.push_back(farthest * k / (points - 1));
        const FlowState state = exact(r.back());
        first.push_back(with_eps ? std::pow(state.temperature, 1 + 1 / flow.c2) : state.temperature);
        u.push_back(state.u_r);
    }
    plot::Figure figure{flow.name + "-scene", 1, 2};
    plot::beside_exact(figure.at(0, 0).labels("$r$", with_eps ? "ε" : "$T$/$T$_{0}"), r, first, shot.r,
                       with_eps ? shot.eps : shot.temperature);
    plot::beside_exact(figure.at(0, 1).labels("$r$", "$u$^{r}"), r, u, shot.r, shot.u_r);
    figure.at(0, 1).legend.shown = false;
    run.save(figure);
}

}  // namespace

PlaneCommand::PlaneCommand() : method_{plane_methods(), any_kernel_names(), {0.8, 20}} {}

void PlaneCommand::declare_common(app::CommandLine& line) {
    line.integer("particles", particles_, 20, 1000000, "in the transverse plane")
        .number("time", time_, {0, 1e6, true}, "length", "proper time tau at which the scene ends")
        .number("courant", courant_, {0, 1.5, true}, "",
                "step over the shortest time in which sound crosses an h");
    method_.declare(line);
}

bool PlaneCommand::listed(report::Run& run) const {
    if (!method_.wants_list()) return false;
    run.print(plane_methods().text());
    return true;
}

void PlaneCommand::run_flow(report::Run& run, const Flow& flow, bool with_eps) const {
    app::require_above("time", time_, flow.tau0, "with this tau0");
    const PlaneMethod method = method_.chosen();
    report::tell(run, method);
    const PlaneScene scene{.n = static_cast<std::size_t>(particles_),
                           .times = {time_},
                           .courant = courant_,
                           .seed = run.seed(),
                           .threads = run.threads(),
                           .progress = run.progress()};
    const Snapshot shot = run_plane(flow, scene, method).back();
    run.record(method.name, shot.x.size(),
               shot.measured() + report::Quantities{{"cpu_seconds", shot.seconds, "s"}});
    report::NamedColumns columns{{"x", shot.x},
                                 {"y", shot.y},
                                 {"r", shot.r},
                                 {"temperature", shot.temperature},
                                 {"exact_temperature", shot.exact_temperature},
                                 {"u_r", shot.u_r},
                                 {"exact_u_r", shot.exact_u_r}};
    if (with_eps) columns.emplace_back("eps", shot.eps), columns.emplace_back("exact_eps", shot.exact_eps);
    run.write("profile.csv", report::csv(columns));
    draw(run, flow, shot, with_eps);
}

void CylinderCommand::declare(app::CommandLine& line) {
    line.number("radius", radius_, {0.1, 1000}, "length", "R, of the cylinder at tau0")
        .number("tau0", tau0_, {1e-3, 1000}, "length", "proper time at which it begins")
        .number("sound-speed-squared", c2_, {0.01, 0.5}, "c^2", "c0^2 of P = c0^2 eps");
    declare_common(line);
}
void CylinderCommand::run(report::Run& run) const {
    if (listed(run)) return;
    const exact::TransverseFlow flow{radius_, tau0_, c2_};
    try {
        flow.check();
    } catch (const std::domain_error& failure) {
        throw app::UsageError{std::string{"--radius, --tau0, --sound-speed-squared: "} + failure.what()};
    }
    if (time_ > flow.last_time())
        throw app::UsageError{
            "--time: " + app::option_text::shown(time_) +
            " is not allowed; at most tau0 + 4 R/c0 = " + app::option_text::shown(flow.last_time())};
    run_flow(run, cylinder(radius_, tau0_, c2_), false);
}

void GubserCommand::declare(app::CommandLine& line) {
    line.number("q", q_, {0.01, 100}, "1/length", "1/q is the transverse size of the flow")
        .number("tau0", tau0_, {1e-3, 1000}, "length", "proper time at which it begins");
    declare_common(line);
}
void GubserCommand::run(report::Run& run) const {
    if (!listed(run)) run_flow(run, gubser(q_, tau0_), true);
}

}  // namespace sph::transverse
