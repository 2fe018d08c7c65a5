#include <cmath>

#include "chapters/04_artificial_viscosity/scenes/noh_plane.hpp"
#include "chapters/04_artificial_viscosity/figures/plane_style.hpp"
#include "chapters/04_artificial_viscosity/scenes/sedov_plane.hpp"
#include "common/core/unstable.hpp"
#include "common/exact/noh.hpp"
#include "common/exact/sedov.hpp"

/// All runs with one thread, so that their CPU times compare.
namespace sph::shocks {
namespace {

const std::vector<std::string> methods{"alpha-beta", "signal", "balsara", "colagrossi", "reconstructed"};

/// What profiles and maps share.
struct Field {
    const Columns<2>& x;
    const Column& r;
    const Column& rho;
};
void draw_map(plot::Panel& panel, const Field& field, double side, double highest, double diameter) {
    panel.labels("$x$", "$y$").x_range(0, side).y_range(0, side);
    panel.equal_aspect = true;
    plot::Discs discs{.name = "density", .diameter = diameter, .bar = {.label = "ρ"}};
    discs.bar.range = std::array{0.0, highest};
    for (std::size_t i = 0; i < field.r.size(); ++i) {
        if (!(field.x[0][i] <= side && field.x[1][i] <= side)) continue;
        discs.x.push_back(field.x[0][i]);
        discs.y.push_back(field.x[1][i]);
        discs.value.push_back(std::min(field.rho[i], highest));
    }
    panel.particles(discs);
}
void draw_profile(plot::Panel& panel, const Field& field, double r_end, plot::Style style) {
    plot::Values r, rho;
    for (std::size_t i = 0; i < field.r.size(); ++i) {
        if (field.r[i] >= r_end) continue;
        r.push_back(field.r[i]);
        rho.push_back(field.rho[i]);
    }
    panel.points(r, rho, dots(style, 2.5));
}

void report_noh(report::Run& run, report::Table& table, const std::string& name, const std::string& label,
                const NohRun& noh) {
    const auto n = static_cast<long>(noh.r.size());
    run.result(name, n, "l1_rho", noh.l1_rho);
    run.result(name, n, "l1_v", noh.l1_v);
    run.result(name, n, "plateau", noh.plateau);
    run.result(name, n, "centre", noh.centre);
    run.result(name, n, "scatter", noh.scatter);
    run.result(name, n, "steps", static_cast<double>(noh.counters.steps));
    run.result(name, n, "cpu_seconds", noh.seconds, "s");
    if (name != "grid") run.result(name, n, "energy_drift", noh.energy_drift);
    table.row({label, report::fixed(static_cast<double>(n), 0), report::number(noh.l1_rho, 2),
               report::number(noh.l1_v, 2), report::number(noh.plateau, 3), report::number(noh.centre, 2),
               report::number(100 * noh.scatter, 1), report::timing(noh.seconds)});
}

void report_sedov(report::Run& run, report::Table& table, const std::string& name, const std::string& label,
                  const SedovRun& blast) {
    const auto n = static_cast<long>(blast.r.size());
    run.result(name, n, "l1_rho", blast.l1_rho);
    run.result(name, n, "l1_v", blast.l1_v);
    run.result(name, n, "l1_p", blast.l1_p);
    run.result(name, n, "shock_radius", blast.shock_radius);
    run.result(name, n, "peak", blast.peak);
    run.result(name, n, "steps", static_cast<double>(blast.counters.steps));
    run.result(name, n, "cpu_seconds", blast.seconds, "s");
    if (name != "grid") run.result(name, n, "energy_drift", blast.energy_drift);
    table.row({label, report::fixed(static_cast<double>(n), 0), report::number(blast.l1_rho, 2),
               report::number(blast.l1_v, 2), report::number(blast.l1_p, 2),
               report::fixed(blast.shock_radius, 3), report::number(blast.peak, 2),
               report::timing(blast.seconds)});
}

}  // namespace

void noh_plane(report::Run& run) {
    NohScene scene;
    scene.n = run.quick() ? 16 : 40;
    report::Table table{{"method", "N", "ρ, L₁", "v, L₁", "ρ behind the shock (16)", "ρ at the centre",
                         "scatter of ρ [%]", "CPU [s]"}};
    for (const std::string& name : methods)
        report_noh(run, table, name, plane_method(name).label, run_noh(scene, plane_method(name)));
    const std::string cubic = "signal-cubic";
    report_noh(run, table, cubic, plane_method(cubic).label, run_noh(scene, plane_method(cubic)));

    scene.n = run.quick() ? 20 : 50;
    const NohRun fine = run_noh(scene, plane_method("reconstructed"));
    const NohRun plain = run_noh(scene, plane_method("signal"));
    report_noh(run, table, "signal", plane_style("signal").label, plain);
    report_noh(run, table, "reconstructed", plane_style("reconstructed").label, fine);
    const auto cells = static_cast<std::size_t>(std::sqrt(static_cast<double>(fine.r.size())));
    const NohRun grid = run_noh_grid(scene, cells);
    report_noh(run, table, "grid", "grid", grid);
    run.fill("noh-plane", table.markdown());

    plot::Figure figure{"noh-plane", 1, 3};
    figure.panel_width = 330;
    const double side = 0.3;
    draw_map(figure.at(0, 0).titled("reconstructed"), {fine.x, fine.r, fine.rho}, side, 18, 3);
    figure.at(0, 0).discs.back().bar.shown = false;
    draw_map(figure.at(0, 1).titled("signal velocity"), {plain.x, plain.r, plain.rho}, side, 18, 3);
    plot::Panel& profile = figure.at(0, 2).labels("$r$", "ρ").x_range(0, 0.35).y_range(0, 19);
    draw_profile(profile, {plain.x, plain.r, plain.rho}, 0.35, plane_style("signal"));
    draw_profile(profile, {fine.x, fine.r, fine.rho}, 0.35, plane_style("reconstructed"));
    draw_profile(profile, {grid.x, grid.r, grid.rho}, 0.35, grid_style());
    const exact::Noh exact{2, scene.gamma, 1, 1};
    plot::Values r, rho;
    for (int k = 0; k <= 700; ++k) {
        r.push_back(0.35 * k / 700.0);
        rho.push_back(exact.at(r.back(), scene.time).rho);
    }
    plot::Style line = exact_line();
    line.layer = 2;
    profile.curve(r, rho, line);
    run.save(figure);
}

void sedov(report::Run& run) {
    SedovScene scene;
    scene.n = run.quick() ? 16 : 40;
    scene.most_steps = 400;  // methods that finish need 270
    report::Table table{
        {"method", "N", "ρ, L₁", "v, L₁", "P, L₁", "shock at (0.4)", "peak / exact", "CPU [s]"}};
    for (const std::string& name : methods) {
        try {
            report_sedov(run, table, name, plane_method(name).label, run_sedov(scene, plane_method(name)));
        } catch (const Unstable&) {
            table.row({plane_method(name).label, report::fixed(static_cast<double>(scene.n * scene.n), 0),
                       "stops", "", "", "", "", ""});
        }
    }
    scene.n = run.quick() ? 20 : 60;
    scene.most_steps = SedovScene{}.most_steps;
    const SedovRun fine = run_sedov(scene, plane_method("signal"));
    report_sedov(run, table, "signal", plane_style("signal").label, fine);
    SedovScene other = scene;
    other.n = scene.n / 2;
    other.quarter = false;
    other.lattice = Lattice::hexagonal;
    const SedovRun hexagonal = run_sedov(other, plane_method("signal"));
    report_sedov(run, table, "signal hexagonal", "the same, hexagonal, whole plane", hexagonal);
    const SedovRun grid = run_sedov_grid(scene);
    report_sedov(run, table, "grid", "grid", grid);
    run.fill("sedov", table.markdown());

    plot::Figure figure{"sedov", 1, 2};
    draw_map(figure.at(0, 0).titled("signal velocity, a quarter"), {fine.x, fine.r, fine.rho}, 0.5, 4, 3.2);
    plot::Panel& profile = figure.at(0, 1).labels("$r$", "ρ").x_range(0, 0.5).y_range(0, 4.2);
    draw_profile(profile, {fine.x, fine.r, fine.rho}, 0.5, plane_style("signal"));
    draw_profile(profile, {grid.x, grid.r, grid.rho}, 0.5, grid_style());
    const exact::Sedov exact{2, scene.gamma, 1, 1};
    plot::Values r, rho;
    for (int k = 0; k <= 1000; ++k) {
        r.push_back(0.5 * k / 1000.0);
        rho.push_back(exact.at(r.back(), fine.time).rho);
    }
    plot::Style line = exact_line();
    line.layer = 2;
    profile.curve(r, rho, line);
    run.save(figure);
}

}  // namespace sph::shocks
