#include "chapters/07_godunov_sph/scenes/uniform_pressure.hpp"

#include <algorithm>
#include <cmath>

#include "common/plot/looks.hpp"
#include "common/plot/method_looks.hpp"
#include "common/report/chapter.hpp"
#include "common/report/comparison.hpp"

namespace sph::godunov {

void uniform_pressure(report::Run& run) {
    using namespace report;
    const Shown rounding = or_word(1e-13, "rounding", digits(2));
    Comparison table{{"jitter"},
                     {{"(7.5)", "sph", digits(2)},
                      {"(7.9), V linear", "linear", digits(2)},
                      {"(7.9), V cubic", "cubic", digits(2)},
                      {"(7.4) by quadrature", "quadrature", rounding},
                      {"halves with either h", "halves", digits(2)},
                      {"h between them", "varying", digits(2)}}};
    plot::Values jitters, sph, linear, cubic, quadrature;
    bool small = true, exact = true, needs_integral = true, own_h = true;
    for (const double jitter : {0.01, 0.03, 0.1, 0.2, 0.3}) {
        const RestingForces rms = resting_forces({.jitter = jitter});
        table.add(run, "jitter " + fixed(jitter, 2), 200, {fixed(jitter, 2)},
                  {{"sph", rms.sph},
                   {"linear", rms.linear},
                   {"cubic", rms.cubic},
                   {"quadrature", rms.quadrature},
                   {"halves", rms.halves},
                   {"varying", rms.varying}});
        jitters.push_back(jitter), sph.push_back(rms.sph), linear.push_back(rms.linear);
        cubic.push_back(rms.cubic), quadrature.push_back(std::max(rms.quadrature, 1e-17));
        if (jitter <= 0.1) small = small && rms.sph > 3.5 * rms.linear && rms.sph > 3.5 * rms.cubic;
        exact = exact && rms.quadrature < 1e-14;
        own_h = own_h && rms.halves > 1.8 * rms.cubic && rms.varying < rms.halves &&
                rms.varying > 0.5 * rms.halves;
        needs_integral = needs_integral && rms.cubic > 0.1 * jitter;
    }
    plot::Figure figure{"uniform-pressure", 1, 1};
    figure.panel_width = 560;
    plot::Panel& panel = figure.at(0, 0).log_log().labels("jitter [d$x$]", "rms acceleration [$P$/(ρ d$x$)]");
    panel.curve(jitters, sph, plot::look_of("alpha-beta", "SPH"));
    plot::Style line = plot::look_of("inutsuka", "$V$ linear");
    line.filled = false, line.dash = plot::Dash::dashed, line.marker_size = 9;
    panel.curve(jitters, linear, line);
    panel.curve(jitters, cubic, plot::look_of("inutsuka", "$V$ cubic"));
    panel.curve(jitters, quadrature, plot::competitor("the integral, by quadrature"));
    panel.legend.outside = true;
    run.save(figure);
    run.fill("uniform-pressure", table.markdown());
    const Pairing pairs = pairing_under_tension();
    run.record("pairs under tension", 64,
               {{"sph", pairs.sph}, {"linear", pairs.linear}, {"cubic", pairs.cubic}});
    run.fill("tensile-ratio", number(pairs.sph / pairs.cubic, 2));
    run.claim(
        "tensile",
        [&] {
            return pairs.sph > 5 * pairs.cubic && std::abs(pairs.linear - pairs.cubic) < 1e-9 * pairs.cubic;
        },
        report::Needs::any_run);
    run.claim(
        "uniform-smaller", [&] { return small; }, report::Needs::any_run);
    run.claim(
        "uniform-exact", [&] { return exact && needs_integral; }, report::Needs::any_run);
    run.claim(
        "uniform-own-h", [&] { return own_h; }, report::Needs::any_run);
}

}  // namespace sph::godunov
