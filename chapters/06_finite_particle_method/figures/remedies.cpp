#include <map>

#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "chapters/06_finite_particle_method/scenes/line_methods.hpp"
#include "common/exact/burgers.hpp"
#include "common/plot/looks.hpp"

/// What keeps moving particles apart, and what it loses.
namespace sph::fpm {
namespace {

const std::vector<double> viscosities{0.1, 0.02, 0.005};
const std::vector<std::string> compared{"sfpm",       "xsph",      "shifting", "repulsion",
                                        "remesh-fit", "remesh-m4", "frame-2",  "frame-4"};

BurgersScene scene_of(const report::Run& run, const std::string& name, double viscosity) {
    BurgersScene scene = moving_methods()[name].on({});
    scene.n = run.quick() ? 50 : 100, scene.viscosity = viscosity;
    for (int k = 1; k < 20; ++k) scene.looks.push_back(0.05 * k);
    return scene;
}

std::string text_of(const BurgersRun& run) {
    if (run.first_crossing >= 0) return "crosses at " + report::fixed(run.first_crossing, 2);
    if (run.stopped >= 0) return "stopped at " + report::fixed(run.stopped, 2);
    return report::number(run.errors.back().linf, 2);
}

/// Other kernels for the naive method: none cures it.
void sweep_kernels(report::Run& run) {
    report::Table table{{"kernel", "h/dx", "first crossing, γ = 0.005"}};
    bool all_cross = true;
    for (const std::string& kernel : any_kernel_names()) {
        BurgersScene scene = moving_methods()["sfpm"].on({});
        scene.viscosity = 0.005, scene.time = 0.6, scene.kernel = kernel;
        scene.stops_at_crossing = true;
        scene.h_over_dx = AnyKernel<1>{kernel}.support < 2.5 ? 1.5 : 1;
        const double crossed = try_burgers(scene).first_crossing;
        all_cross = all_cross && crossed > 0;
        table.row(
            {kernel, report::number(scene.h_over_dx, 2), crossed < 0 ? "none" : report::fixed(crossed, 2)});
    }
    run.fill("kernels", table.markdown());
    run.claim("no-kernel-cures", [&] { return all_cross; });
}

void draw(plot::Figure& figure, const std::map<std::string, BurgersRun>& runs) {
    const exact::Burgers exact{0.005};
    plot::Panel& layer = figure.at(0, 0).titled("γ = 0.005, $t$ = 1").labels("$x$", "$u$");
    layer.x_range(0.93, 1).y_range(-0.1, 0.9);
    plot::Panel& error = figure.at(0, 1).log_y().titled("γ = 0.005").labels("$t$", "largest error of $u$");
    plot::Panel& space =
        figure.at(0, 2).log_y().titled("γ = 0.005, $t$ = 1").labels("$x$", "space of a particle");
    plot::draw_exact(layer, 0.93, 1, [&](double x) { return exact.velocity(x, 1); });
    for (const std::string name : {"sfpm", "remesh-fit", "remesh-m4", "frame-2", "frame-4"}) {
        const auto found = runs.find(name + " 0.005");
        if (found == runs.end()) continue;
        const BurgersRun& line = found->second;
        const plot::Style look = moving_methods()[name].styled();
        if (name != "sfpm") layer.points(line.x, line.u, plot::dots(look, 5));
        plot::Values t, off;
        for (const ErrorsAt& one : line.errors) t.push_back(one.t), off.push_back(one.linf);
        error.curve(t, off, look);
        if (!name.starts_with("frame")) continue;
        plot::Values s;
        for (std::size_t i = 0; i < line.x.size(); ++i) s.push_back(space_of(line.x, i));
        space.curve(line.x, s, plot::line(look));
    }
    space.legend.shown = layer.legend.shown = false;
    error.y_range(1e-6, 10);
}

}  // namespace

void remedies(report::Run& run) {
    std::map<std::string, BurgersRun> runs;
    report::Table table{{"method", "γ = 0.1: largest error at t = 1", "γ = 0.02", "γ = 0.005",
                         "largest to t = 1, γ = 0.005"}};
    report::Table losses{
        {"method", "γ", "remeshings", "change of the carried mass %", "of the integral of u %"}};
    for (const std::string& name : compared) {
        const LineMethod& method = moving_methods()[name];
        std::vector<std::string> row{method.label};
        for (const double viscosity : viscosities) {
            const std::string which = name + " " + written(viscosity);
            const BurgersRun& line = runs[which] = try_burgers(scene_of(run, name, viscosity));
            run.record(name + " gamma " + written(viscosity), line.x.size(), line.measured());
            row.push_back(text_of(line));
            if (line.remeshings > 0)
                losses.row({method.label, written(viscosity), std::to_string(line.remeshings),
                            std::abs(line.mass_change) < 1e-11 ? "< 1e-9"
                                                               : report::number(100 * line.mass_change, 2),
                            report::number(100 * line.momentum_change, 2)});
        }
        const BurgersRun& hard = runs[name + " 0.005"];
        row.push_back(hard.first_crossing >= 0 || hard.stopped >= 0 ? "–"
                                                                    : report::number(hard.worst_linf, 2));
        table.row(row);
    }
    run.fill("remedies", table.markdown());
    run.fill("losses", losses.markdown());
    const auto& of = runs;
    run.claim("frame-holds", [&] {
        bool holds = true;
        for (const char* which : {"frame-4 0.1", "frame-4 0.02", "frame-4 0.005"})
            holds = holds && of.at(which).first_crossing < 0 && of.at(which).worst_linf < 2e-3;
        return holds && of.at("frame-2 0.005").worst_linf > 10 * of.at("frame-4 0.005").worst_linf;
    });
    run.claim("remeshing-holds", [&] {
        const BurgersRun &fit = of.at("remesh-fit 0.005"), &m4 = of.at("remesh-m4 0.005");
        return fit.first_crossing < 0 && m4.first_crossing < 0 && fit.errors.back().linf > 0.01 &&
               m4.errors.back().linf > 0.01 && fit.errors.back().linf < 0.1 && m4.errors.back().linf < 0.1;
    });
    run.claim("what-remeshing-loses", [&] {
        const BurgersRun &fit = of.at("remesh-fit 0.005"), &m4 = of.at("remesh-m4 0.005");
        return std::abs(fit.mass_change) > 0.1 && std::abs(m4.mass_change) < 1e-11 &&
               std::abs(m4.momentum_change) > 1e-3 && std::abs(fit.momentum_change) > 1e-3;
    });
    BurgersScene taylor = scene_of(run, "taylor", 0.005);
    taylor.stops_at_crossing = true;
    const double taylor_crosses = try_burgers(taylor).first_crossing;
    run.claim("answer-moving", [&] {
        return of.at("sfpm 0.005").first_crossing > 0 && taylor_crosses > 0 &&
               of.at("frame-4 0.005").worst_linf < 0.1 * of.at("remesh-fit 0.005").worst_linf;
    });
    run.claim("xsph-does-not", [&] {
        bool both_cross = true;
        for (const std::string name : {"xsph", "shifting"}) {
            for (const std::string viscosity : {" 0.02", " 0.005"})
                both_cross = both_cross && of.at(name + viscosity).first_crossing > 0;
        }
        return both_cross;
    });
    run.claim("repulsion-holds", [&] {
        bool holds = true;
        for (const char* which : {"repulsion 0.1", "repulsion 0.02", "repulsion 0.005"}) {
            const BurgersRun& line = of.at(which);
            holds = holds && line.first_crossing < 0 && line.stopped < 0 && line.errors.back().linf > 0.5;
        }
        return holds;
    });
    sweep_kernels(run);
    plot::Figure figure{"remedies", 1, 3};
    draw(figure, runs);
    run.save(figure);
}

}  // namespace sph::fpm
