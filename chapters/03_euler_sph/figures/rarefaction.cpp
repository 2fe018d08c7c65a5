#include "chapters/03_euler_sph/scenes/rarefaction.hpp"

#include <map>

#include "common/exact/rarefaction.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"
#include "common/report/norms.hpp"

namespace sph::euler {
namespace {

struct Line {
    GasMethod method;
    bool graded;
};
/// All methods with equal masses, and the one with Omega with graded masses too.
std::vector<Line> all_lines() {
    std::vector<Line> lines;
    for (const GasMethod& method : compared_methods()) {
        if (method.name != "super-gaussian") lines.push_back({method, false});
    }
    GasMethod best = lines.back().method;
    best.label += ", graded masses";
    best.look = {.label = best.label, .colour = plot::cycle(5), .marker = plot::Marker::plus};
    lines.push_back({best, true});
    return lines;
}

/// Every third of the right half.
plot::Values few(const Column& values) {
    plot::Values some;
    for (std::size_t i = values.size() / 2; i < values.size(); i += 3) some.push_back(values[i]);
    return some;
}
plot::Values difference(const Column& a, const Column& b) {
    plot::Values all;
    for (std::size_t i = a.size() / 2; i < a.size(); ++i) all.push_back(a[i] - b[i]);
    return all;
}
plot::Values right_half(const Column& values) {
    return {values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end()};
}

/// What is drawn of the run with 200 particles.
void draw(plot::Panel& speed, plot::Panel& miss, const Line& line, const RarefactionRun& gas) {
    const std::string& name = line.method.name;
    if (name == "fixed-h" || (name == "consistent-h" && !line.graded))
        speed.points(few(gas.x), few(gas.v), plot::dots(line.method.look, 4));
    if (name == "without-omega" || name == "consistent-h")
        miss.curve(right_half(gas.x), difference(gas.v, gas.exact_v), plot::line(line.method.look));
}

struct Errors {
    plot::Values v;                       // against N
    double rho = 0, edge = 0, drift = 0;  // with 200 particles
};

void claims(report::Run& run, const std::map<std::string, Errors>& all) {
    const auto &one = all.at("fixed-h").v, &without = all.at("without-omega").v,
               &with = all.at("consistent-h").v, &graded = all.at("consistent-h graded").v;
    run.claim("fan-one-h", [&] { return one.back() > one.front() && all.at("fixed-h").edge < 0.4; });
    run.claim("fan-without-omega",
              [&] { return without[3] > 0.9 * without[2] && without[3] > 0.005 && with[2] / with[3] > 1.8; });
    run.claim("fan-graded", [&] { return graded[2] < 0.5 * with[2]; });
    run.claim("fan-edge-is-short", [&] {
        const double edge = all.at("consistent-h").edge;
        return edge < 0.98 && all.at("consistent-h graded").edge > edge;
    });
}

}  // namespace

void rarefaction(report::Run& run) {
    plot::Figure figure{"rarefaction", 1, 3};
    figure.panel_width = 275;
    plot::Panel& left = figure.at(0, 0).titled("velocity").labels("$x$", "$v$").x_range(0, 1.8);
    plot::Panel& middle =
        figure.at(0, 1).titled("its error").labels("$x$", "$v$ − exact").x_range(0, 1.8).y_range(-0.1, 0.1);
    plot::Panel& right = figure.at(0, 2)
                             .log_log()
                             .titled("convergence")
                             .labels("particles $N$", "relative $L$_{1} error of $v$");
    right.x.ticks = {50, 100, 200, 400};
    const exact::Rarefaction exact{1, 2, 1.4, 0.5};
    plot::draw_exact(left, 0, 1.8, [&](double x) { return exact.at(x, 0.4).v; });
    plot::draw_exact(middle, 0, 1.8, [](double) { return 0.0; });
    const auto sizes = run.sizes({50, 100, 200}, {50, 100, 200, 400});
    report::Comparison table{{"h", "masses"},
                             {{"v, N = 200", "l1_v", report::digits(2)},
                              {"ρ, N = 200", "l1_rho", report::digits(2)},
                              {"v, order", "rate_l1_v", report::decimals(1)},
                              {"energy", "energy_drift", report::digits(1)}}};
    std::map<std::string, Errors> all;
    for (const Line& line : all_lines()) {
        const GasMethod& method = line.method;
        const std::string name = method.name + (line.graded ? " graded" : "");
        Errors& errors = all[name];
        plot::Values n;
        report::Quantities shown;
        for (const std::size_t size : sizes) {
            RarefactionScene scene;
            scene.n = size;
            scene.graded = line.graded;
            scene.threads = run.threads();
            const RarefactionRun gas = run_rarefaction(scene, method);
            n.push_back(static_cast<double>(size));
            errors.v.push_back(gas.velocity_error);
            run.record(name, size, gas.measured());
            run.record(name, size, {{"edge_over_front", gas.edge / gas.front}});
            if (size != 200) continue;
            shown = gas.measured();
            errors.edge = gas.edge / gas.front;
            draw(left, middle, line, gas);
        }
        right.curve(n, errors.v, method.look);
        const double order = report::fitted_order(n, errors.v);
        run.record(name, sizes.back(), {{"rate_l1_v", order}});
        shown.push_back({"rate_l1_v", order});
        table.show({method.label, line.graded ? "graded" : "equal"}, shown);
        if (name == "consistent-h") run.fill("fan-edge", report::percent(1 - errors.edge));
    }
    left.legend.shown = false;
    middle.legend.shown = false;
    right.legend.outside = true;
    right.slope(-1, 100, 200, 0.02, "order 1");
    run.save(figure);
    run.fill("rarefaction", table.markdown());
    claims(run, all);
}

}  // namespace sph::euler
