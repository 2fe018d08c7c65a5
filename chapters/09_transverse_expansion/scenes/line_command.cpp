#include "chapters/09_transverse_expansion/scenes/line.hpp"
#include "common/app/error.hpp"
#include "common/app/option_text.hpp"
#include "common/app/parameters.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"

namespace sph::transverse {
namespace {

void draw_line(report::Run& run, const LineProfile& profile) {
    plot::Figure figure{"line-scene", 1, 2};
    plot::beside_exact(figure.at(0, 0).labels("$r$", "$T$/$T$_{0}"), profile.r, profile.exact_temperature,
                       profile.r, profile.temperature);
    plot::beside_exact(figure.at(0, 1).labels("$r$", "$u^r$"), profile.r, profile.exact_u_r, profile.r,
                       profile.u_r);
    figure.at(0, 1).legend.shown = false;
    run.save(figure);
}

}  // namespace

void LineCommand::declare(app::CommandLine& line) {
    line.integer("particles", particles_, 10, 100000, "rings in r < R")
        .number("time", time_, {0, 1e6, true}, "length", "proper time tau at which the scene ends")
        .number("radius", flow_.radius, {0.1, 1000}, "length", "R, of the cylinder at tau0")
        .number("tau0", flow_.tau0, {1e-3, 1000}, "length", "proper time at which it begins")
        .number("sound-speed-squared", flow_.c2, {0.01, 0.5}, "c^2", "c0^2 of P = c0^2 eps")
        .number("h-over-dx", h_over_dx_, {0.8, 20}, "", "h in units of nu/s*")
        .number("courant", courant_, {0, 1, true}, "",
                "step over the shortest time in which sound crosses an h")
        .flag("negative-images", negative_, "images of negative entropy behind the axis, which fail");
}

void LineCommand::run(report::Run& run) const {
    app::require_above("time", time_, flow_.tau0, "with this tau0");
    try {
        flow_.check();
    } catch (const std::domain_error& failure) {
        throw app::UsageError{std::string{"--radius, --tau0, --sound-speed-squared: "} + failure.what()};
    }
    if (time_ > flow_.last_time())
        throw app::UsageError{
            "--time: " + app::option_text::shown(time_) +
            " is not allowed; at most tau0 + 4 R/c0 = " + app::option_text::shown(flow_.last_time())};
    const LineScene scene{.flow = flow_,
                          .n = static_cast<std::size_t>(particles_),
                          .times = {time_},
                          .share = negative_ ? -1.0 : 1.0,
                          .h_over_dx = h_over_dx_,
                          .courant = courant_,
                          .threads = run.threads(),
                          .progress = run.progress()};
    const LineProfile profile = run_line(scene).back();
    run.record(negative_ ? "negative-images" : "mirror-images", scene.n,
               profile.measured() + report::Quantities{{"cpu_seconds", profile.seconds, "s"}});
    run.write("profile.csv", report::csv({{"r", profile.r},
                                          {"temperature", profile.temperature},
                                          {"exact_temperature", profile.exact_temperature},
                                          {"u_r", profile.u_r},
                                          {"exact_u_r", profile.exact_u_r}}));
    draw_line(run, profile);
}

}  // namespace sph::transverse
