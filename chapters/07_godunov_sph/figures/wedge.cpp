#include <algorithm>
#include <cmath>
#include <numbers>

#include "chapters/07_godunov_sph/scenes/wedge_command.hpp"
#include "common/core/unstable.hpp"
#include "common/plot/looks.hpp"
#include "common/report/text.hpp"

namespace sph::godunov {
namespace {

constexpr double in_degrees = 180 / std::numbers::pi;
constexpr double height_of_cut = 0.3;  // through shock and fan, above the floor's layer

/// What a row of the table and a curve need of a flow, by particles or on a grid.
struct FlowSeen {
    std::string name, label;
    plot::Style look;
    std::size_t cells;
    ChannelFlow flow;
    Measured measured;
    long steps;
    double seconds;
};
FlowSeen seen(const ChannelMethod& method, std::size_t cells, const WedgeRun& run) {
    return {method.name, method.label, method.styled(),    cells,
            run.flow,    run.measured, run.counters.steps, run.seconds};
}
FlowSeen seen(const WedgeGrid& grid) {
    return {"grid",    "grid",        plot::competitor("grid"), grid.flow.cells.ny,
            grid.flow, grid.measured, grid.solver.steps(),      grid.seconds};
}

/// All runs of the figure.
struct WedgeRuns {
    std::vector<FlowSeen> sizes, methods, grids;  // godunov by N; the methods at the largest N; the grid by N
    std::vector<FlowSeen> linear;             // the paper's scheme with V cubic and linear, at the smallest N
    double mass_error = 0, energy_error = 0;  // the largest of any run; of godunov
    long through = 0;
    double naive_end = 0;  // when the run without images stops
};

WedgeScene scene_of(const report::Run& run, std::size_t cells) {
    WedgeScene scene;
    scene.cells = cells, scene.threads = run.threads();
    if (run.quick()) scene.times = 1.5;
    return scene;
}

FlowSeen flow_by(report::Run& run, WedgeRuns& runs, const std::string& name, std::size_t cells) {
    const ChannelMethod& method = channel_methods()[name];
    const WedgeRun wedge = run_wedge(scene_of(run, cells), method);
    run.record(name, cells, wedge.quantities());
    runs.mass_error = std::max(runs.mass_error, std::abs(wedge.mass_error));
    if (name == "godunov") runs.energy_error = std::max(runs.energy_error, std::abs(wedge.energy_error));
    runs.through += wedge.through;
    return seen(method, cells, wedge);
}

/// When the gas that nothing holds has disturbed what enters.
double end_without_images(const report::Run& run, std::size_t cells) {
    WedgeScene scene = scene_of(run, cells);
    scene.mirrors = false;
    try {
        run_wedge(scene, channel_methods()["godunov"]);
    } catch (const Unstable& failure) {
        return failure.time;
    }
    return scene.end();
}

WedgeRuns run_all(report::Run& run) {
    WedgeRuns runs;
    const auto sizes = run.sizes({12}, {16, 32});
    for (const std::size_t cells : sizes) runs.sizes.push_back(flow_by(run, runs, "godunov", cells));
    for (const char* name : {"first-order", "inutsuka", "alpha-beta", "alpha-beta-twice", "geometric-volume"})
        runs.methods.push_back(flow_by(run, runs, name, sizes.back()));
    if (!run.quick()) {
        for (const char* name : {"inutsuka", "inutsuka-linear"})
            runs.linear.push_back(flow_by(run, runs, name, sizes.front()));
    }
    WedgeGrid grid = run_wedge_grid(scene_of(run, sizes.front()));
    runs.grids.push_back(seen(grid));
    for (const std::size_t cells : run.sizes({}, {32, 64})) {
        grid = run_wedge_grid(scene_of(run, cells));
        runs.grids.push_back(seen(grid));
    }
    if (!run.quick()) runs.grids.push_back(seen(refined(scene_of(run, 128), grid)));
    for (const FlowSeen& one : runs.grids) {
        run.record("grid", one.cells,
                   {{"shock_angle", one.measured.beta, "degrees"},
                    {"mach_behind_shock", one.measured.mach_behind},
                    {"mach_after_fan", one.measured.mach_after},
                    {"least_mach", one.measured.least_mach},
                    {"sonic_height", one.measured.sonic_height},
                    {"cpu_seconds", one.seconds, "s"}});
    }
    runs.naive_end = end_without_images(run, sizes.front());
    run.record("no-images", sizes.front(), {{"end", runs.naive_end, "height/c"}});
    return runs;
}

void draw_flows(plot::Figure& figure, const WedgeRuns& runs) {
    const FlowSeen& grid = runs.grids[std::min<std::size_t>(1, runs.grids.size() - 1)];
    const FlowSeen* shown[] = {&runs.sizes.back(), &grid,           &runs.methods[0], &runs.methods[1],
                               &runs.methods[2],   &runs.methods[3]};
    for (int k = 0; k < 6; ++k) {
        plot::Panel& panel = figure.at(k / 2, k % 2);
        draw_mach(panel, {}, shown[k]->flow, true);
        panel.titled(shown[k]->label);
    }
}

/// The Mach number along a line of constant y.
void draw_line(plot::Panel& panel, const FlowSeen& one, double y, const std::string& label, plot::Dash dash) {
    constexpr int points = 240;
    const auto [begin, end] = *panel.x.range;
    plot::Values x, mach;
    for (int k = 0; k <= points; ++k) {
        x.push_back(begin + (end - begin) * k / points);
        mach.push_back(one.flow.mach_at(x.back(), y));
    }
    plot::Style look = plot::line(one.look);
    look.label = label, look.dash = dash;
    panel.curve(x, mach, look);
}

void draw_cuts(plot::Figure& figure, const WedgeRuns& runs) {
    const WedgeChannel channel;
    plot::Panel& cut = figure.at(3, 0).labels("$x$", "Mach number at $y$ = 0.3").x_range(-0.6, 0.9);
    plot::draw_exact(cut, -0.6, 0.9, [&](double x) { return channel.exact_mach(x, height_of_cut); });
    plot::Panel& ceiling = figure.at(3, 1).labels("$x$", "Mach number at the ceiling").x_range(0.2, 1.2);
    const double normal =
        exact::ObliqueShock{channel.mach, 0, channel.gamma, exact::ObliqueShock::Branch::strong}
            .mach_behind();
    ceiling.curve({0.2, 1.2}, {normal, normal},
                  {.label = "behind a normal shock", .colour = plot::black, .dash = plot::Dash::dotted});
    const auto draw_both = [&](const FlowSeen& one, const std::string& label, plot::Dash dash) {
        draw_line(cut, one, height_of_cut, label, dash);
        draw_line(ceiling, one, 1, label, dash);
    };
    draw_both(runs.sizes.back(), "Godunov SPH", plot::Dash::solid);
    draw_both(runs.methods[0], "first order", plot::Dash::dashed);
    draw_both(runs.methods[2], "α = 1, β = 2", plot::Dash::solid);
    if (runs.grids.size() > 3) {
        draw_line(ceiling, runs.grids[1], 1, "grid, 32 across", plot::Dash::dash_dotted);
        draw_line(ceiling, runs.grids[3], 1, "grid, 128 across", plot::Dash::solid);
    }
}

void fill_table(report::Run& run, const WedgeRuns& runs) {
    const WedgeChannel channel;
    report::Table table{{"flow", "β, degrees", "$`M_2`$", "$`M_3`$", "least M", "steps", "s"}};
    const exact::ObliqueShock shock = channel.shock();
    table.row({"theory", report::fixed(shock.beta() * in_degrees, 2), report::fixed(shock.mach_behind(), 3),
               report::fixed(channel.fan().mach_behind(), 3), "0.577", "", ""});
    const auto row = [&](const std::string& label, const FlowSeen& one) {
        table.row({label, "≈" + report::fixed(one.measured.beta, 2),
                   "≈" + report::fixed(one.measured.mach_behind, 3),
                   "≈" + report::fixed(one.measured.mach_after, 3),
                   "≈" + report::fixed(one.measured.least_mach, 2), "≈" + std::to_string(one.steps),
                   report::timing(one.seconds)});
    };
    for (const std::size_t k : {1U, 3U}) {
        if (k < runs.grids.size())
            row("grid, " + std::to_string(runs.grids[k].cells) + " cells across", runs.grids[k]);
    }
    row("Godunov SPH", runs.sizes.back());
    for (std::size_t k = 0; k < 4; ++k) row(runs.methods[k].label, runs.methods[k]);
    run.fill("wedge", table.markdown());
}

void claim_all(report::Run& run, const WedgeRuns& runs) {
    const WedgeChannel channel;
    const double beta = channel.shock().beta() * in_degrees, mach = channel.shock().mach_behind();
    const auto off_angle = [&](const FlowSeen& one) { return std::abs(one.measured.beta - beta); };
    const auto off_mach = [&](const FlowSeen& one) { return std::abs(one.measured.mach_behind / mach - 1); };
    const auto off_fan = [&](const FlowSeen& one) {
        return std::abs(one.measured.mach_after / channel.fan().mach_behind() - 1);
    };
    const FlowSeen& best = runs.sizes.back();
    const FlowSeen &first = runs.methods[0], &paper = runs.methods[1], &viscous = runs.methods[2],
                   &twice = runs.methods[3], &geometric = runs.methods[4];
    run.claim("wedge-theory", [&] {
        return off_angle(best) < 0.4 && off_mach(best) < 5e-3 &&
               off_angle(runs.sizes[0]) > 2 * off_angle(best) && off_mach(runs.sizes[0]) > 2 * off_mach(best);
    });
    run.claim("wedge-geometric", [&] {
        return off_angle(geometric) < 0.6 * off_angle(best) && off_mach(geometric) < 0.6 * off_mach(best);
    });
    run.claim("wedge-layer", [&] {
        return best.measured.entropy_at_floor > 1.03 && std::abs(best.measured.entropy_above - 1) < 0.003;
    });
    run.claim("wedge-fan", [&] {
        return off_fan(best) > 0.01 && off_fan(best) < 0.02 && off_fan(viscous) < 0.01 &&
               off_fan(runs.grids[1]) < 0.003;
    });
    run.claim("wedge-first",
              [&] { return first.measured.least_mach > 1.1 && off_fan(first) > 2 * off_fan(best); });
    run.claim("wedge-viscous", [&] {
        return off_angle(viscous) > 1.2 * off_angle(best) && off_mach(viscous) > 1.5 * off_mach(best) &&
               off_angle(twice) > off_angle(viscous) && best.seconds > 1.5 * viscous.seconds;
    });
    run.claim("wedge-paper", [&] {
        return off_mach(paper) < 0.01 && paper.seconds > 1.4 * best.seconds &&
               off_mach(runs.linear[1]) > off_mach(runs.linear[0]);
    });
    run.claim("wedge-stem", [&] {
        const double least[] = {runs.grids[0].measured.least_mach, runs.grids[1].measured.least_mach,
                                runs.grids[2].measured.least_mach, runs.grids[3].measured.least_mach};
        return least[0] > 0.95 && least[1] < 0.85 && least[2] < 0.65 && least[3] < 0.62 && least[3] > 0.57 &&
               least[2] > least[3];
    });
    run.claim("wedge-least", [&] {
        return best.measured.least_mach < 0.96 && viscous.measured.least_mach > best.measured.least_mach &&
               twice.measured.least_mach > 1;
    });
    run.claim(
        "wedge-budget", [&] { return runs.mass_error < 1e-12 && runs.energy_error < 3e-3; },
        report::Needs::any_run);
    run.claim(
        "wedge-walls", [&] { return runs.through == 0 && runs.naive_end < 0.3; }, report::Needs::any_run);
    run.claim("wedge-grid", [&] {
        return best.seconds > 5 * runs.grids[1].seconds &&
               runs.grids[1].measured.least_mach < best.measured.least_mach;
    });
}

}  // namespace

void wedge(report::Run& run) {
    const WedgeRuns runs = run_all(run);
    plot::Figure figure{"wedge", 4, 2};
    figure.panel_width = 440;
    draw_flows(figure, runs);
    draw_cuts(figure, runs);
    run.save(figure);
    fill_table(run, runs);
    run.fill("wedge-naive", report::number(runs.naive_end, 1));
    run.fill("wedge-energy", "≈" + report::number(100 * runs.energy_error, 1) + " %");
    claim_all(run, runs);
}

}  // namespace sph::godunov
