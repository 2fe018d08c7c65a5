#include <cmath>
#include <map>

#include "chapters/04_artificial_viscosity/scenes/plane_lattice.hpp"
#include "chapters/04_artificial_viscosity/scenes/shear_layer.hpp"
#include "chapters/07_godunov_sph/scenes/godunov_methods.hpp"
#include "chapters/07_godunov_sph/scenes/gresho.hpp"
#include "chapters/07_godunov_sph/scenes/sliding.hpp"
#include "common/exact/gresho.hpp"
#include "common/plot/looks.hpp"
#include "common/plot/method_looks.hpp"
#include "common/report/comparison.hpp"

/// Flow without shocks in the plane: a wave of shear, a vortex, and streams that slide along each other. All
/// runs with one thread, so that their CPU times compare.
namespace sph::godunov {
namespace {

struct InPlane {
    GreshoRun vortex;
    SlidingRun sliding;
    double shear = 0;  ///< nu of the shear wave in c_s h (of the grid: in c_s dx)
};
using All = std::map<std::string, InPlane>;

std::vector<Method<2>> contestants() {
    std::vector<Method<2>> all = plane_methods().named({"inutsuka", "first-order", "along-line", "godunov"});
    for (Method<2> method : shocks::plane_methods().named({"alpha-beta", "reconstructed"})) {
        if (method.name == "reconstructed") method.look.filled = false, method.look.dash = plot::Dash::dashed;
        all.push_back(method);
    }
    return all;
}

report::Comparison vortex_table() {
    using namespace report;
    return {{"method"},
            {{"shear: ν / (c_s h)", "shear_viscosity", decimals(3)},
             {"vortex: v %", "l1_v", in_percent()},
             {"its peak %", "peak", in_percent()},
             {"sliding: growth %", "growth", in_percent()},
             {"CPU [s]: vortex", "cpu_seconds", time_in(1)},
             {"sliding", "sliding_cpu_seconds", time_in(1)}}};
}
report::Quantities measured(const InPlane& one) {
    report::Quantities all = one.vortex.measured();
    all.push_back({"shear_viscosity", one.shear});
    all.push_back({"growth", one.sliding.growth / one.sliding.theory});
    all.push_back({"sliding_cpu_seconds", one.sliding.seconds, "s"});
    return all;
}

void draw(report::Run& run, const All& all, const std::vector<Method<2>>& methods) {
    plot::Figure figure{"vortices", 1, 2};
    figure.panel_width = 420;
    plot::Panel& vortex = figure.at(0, 0).titled("vortex, t = 1").labels("$r$", "$v$").x_range(0, 0.5);
    plot::Panel& sliding = figure.at(0, 1).titled("sliding streams").labels("$t$", "amplitude of $v$_{y}");
    sliding.log_y();
    sliding.legend.shown = false;
    vortex.legend.outside = false;
    const auto add = [&](const InPlane& one, const plot::Style& look) {
        const Column weight(one.vortex.r.size(), 1);
        const auto rings = shocks::ring_means(one.vortex.r, one.vortex.v, weight, 0.02, 0.5);
        vortex.curve(rings.r, rings.value, look);
        sliding.curve(one.sliding.t, one.sliding.amplitude, look);
    };
    for (const Method<2>& method : methods) {
        if (method.name == "inutsuka") continue;
        add(all.at(method.name), method.styled());
    }
    add(all.at("grid"), plot::competitor("grid"));
    const exact::Gresho exact{1, 0.2, 1, 5};
    plot::draw_exact(vortex, 0, 0.5, [&](double r) { return exact.at(r).v; });
    const SlidingRun& any = all.at("godunov").sliding;
    plot::draw_exact(
        sliding, 0, any.t.back(), [&](double t) { return std::exp(any.theory * t); }, plot::exact("theory"));
    run.save(figure);
}

void assert_text(report::Run& run, const All& all, const All& fine) {
    const auto error = [&](const char* name) { return all.at(name).vortex.l1_v; };
    const auto growth = [&](const char* name) {
        return all.at(name).sliding.growth / all.at(name).sliding.theory;
    };
    run.claim("vortices-half-step", [&] {
        const auto shear = [&](const char* name) { return all.at(name).shear; };
        return shear("along-line") > 0.75 * shear("alpha-beta") &&
               shear("along-line") > 8 * shear("godunov") && shear("inutsuka") > 5 * shear("godunov");
    });
    run.claim("vortices-repaired", [&] {
        return error("godunov") < 0.65 * error("along-line") &&
               growth("godunov") > growth("along-line") + 0.15 && growth("first-order") < 0;
    });
    run.claim("vortices-paper", [&] {
        return growth("inutsuka") < 0.65 && growth("reconstructed") > 0.75 &&
               error("inutsuka") > 1.2 * error("reconstructed");
    });
    run.claim("vortices-viscosity", [&] {
        return error("godunov") < error("reconstructed") && growth("godunov") < growth("reconstructed") &&
               growth("godunov") > growth("reconstructed") - 0.05 &&
               (run.checking() ||
                all.at("godunov").vortex.seconds > 1.2 * all.at("reconstructed").vortex.seconds);
    });
    run.claim("vortices-fine", [&] {
        const auto fine_error = [&](const char* name) { return fine.at(name).vortex.l1_v; };
        const auto fine_growth = [&](const char* name) {
            return fine.at(name).sliding.growth / fine.at(name).sliding.theory;
        };
        for (const char* name : {"godunov", "reconstructed"}) {
            if (!(fine_error(name) < 0.75 * error(name) && fine_growth(name) > 0.9 &&
                  fine_growth(name) < 1.02))
                return false;
        }
        return true;
    });
    run.claim("vortices-grid", [&] {
        return error("grid") < 0.25 * error("godunov") && growth("grid") > growth("godunov") &&
               (run.checking() || all.at("grid").vortex.seconds < 0.1 * all.at("godunov").vortex.seconds);
    });
}

}  // namespace

void vortices(report::Run& run) {
    const auto measure = [&](const Method<2>& method, std::size_t n, double time) {
        return InPlane{run_gresho({.time = time, .n = n}, method), run_sliding({.n = n}, method), 0};
    };
    const std::size_t n = run.quick() ? 12 : 32;
    const double time = run.quick() ? 0.2 : 1;
    const shocks::ShearScene shear{.time = 1, .n = n};
    report::Comparison table = vortex_table();
    All all, fine;
    const std::vector<Method<2>> methods = contestants();
    for (const Method<2>& method : methods) {
        InPlane& one = all[method.name] = measure(method, n, time);
        const shocks::ShearRun wave = run_shear(shear, method);
        one.shear = wave.viscosity / wave.h;
        table.add(run, method.name, n, {method.label}, measured(one));
    }
    InPlane& grid = all["grid"] = {run_gresho_grid({.time = time, .n = n}), run_sliding_grid({.n = n}), 0};
    const shocks::ShearRun wave = run_shear_grid(shear);
    grid.shear = wave.viscosity / wave.h;
    table.add(run, "grid", n, {"grid"}, measured(grid));
    draw(run, all, methods);
    run.fill("vortices", table.markdown());
    if (!run.quick()) {
        for (const Method<2>& method : methods) {
            if (method.name != "godunov" && method.name != "reconstructed") continue;
            const InPlane& one = fine[method.name] = measure(method, 2 * n, time);
            run.record(method.name, 2 * n, measured(one));
            run.fill("vortices-fine-" + method.name, report::percent(one.vortex.l1_v) + " %");
        }
    }
    assert_text(run, all, fine);
}

}  // namespace sph::godunov
