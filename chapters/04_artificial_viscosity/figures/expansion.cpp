#include <algorithm>

#include "chapters/04_artificial_viscosity/scenes/tube.hpp"
#include "common/plot/looks.hpp"

namespace sph::shocks {
namespace {

/// Where a logarithmic axis can show the density: it has no vacuum.
void draw_where_dense(plot::Panel& panel, const Profile& exact) {
    Column x, rho;
    for (std::size_t i = 0; i < exact.x.size(); ++i) {
        if (exact.rho[i] < 1e-3) continue;
        x.push_back(exact.x[i]);
        rho.push_back(exact.rho[i]);
    }
    panel.curve(x, rho, plot::exact());
}

}  // namespace

void expansion(report::Run& run) {
    plot::Figure figure{"expansion", 1, 3};
    figure.panel_width = 300;
    plot::Panel& rho = figure.at(0, 0).titled("123 problem, 200 particles").labels("$x$", "ρ");
    plot::Panel& u = figure.at(0, 1).labels("$x$", "$u$");
    plot::Panel& empty = figure.at(0, 2).log_y().titled("into a vacuum, 200 particles").labels("$x$", "ρ");
    TubeScene scene{{1, -2, 0.4}, {1, 2, 0.4}, 1.4, 0.15};
    scene.n = run.quick() ? 60 : 200;
    TubeScene vacuum{{1, 0, 1}, {0, 0, 0}, 1.4, 0.1};
    vacuum.n = scene.n;
    report::Table table{{"method", "123: ρ %", "v %", "P %", "u %", "vacuum: ρ %", "v %"}};
    const Profile exact_apart = exact_profile(scene);
    rho.curve(exact_apart.x, exact_apart.rho, plot::exact());
    u.curve(exact_apart.x, exact_apart.u, plot::exact());
    draw_where_dense(empty, exact_profile(vacuum));
    std::vector<double> apart_errors, vacuum_errors;
    for (const Method<1>& method : tube_methods().named({"signal", "price", "reconstructed"})) {
        const TubeRun apart = run_tube(scene, method), into = run_tube(vacuum, method);
        const plot::Style look = plot::dots(method.styled());
        rho.points(apart.profile.x, apart.profile.rho, look);
        u.points(apart.profile.x, apart.profile.u, look);
        empty.points(into.profile.x, into.profile.rho, look);
        run.record("123 " + method.name, scene.n, {{"l1_rho", apart.l1_rho}, {"l1_u", apart.l1_u}});
        run.record("vacuum " + method.name, scene.n, {{"l1_rho", into.l1_rho}, {"l1_v", into.l1_v}});
        apart_errors.push_back(apart.l1_rho), vacuum_errors.push_back(into.l1_rho);
        std::vector<std::string> row{method.label};
        for (const double error : {apart.l1_rho, apart.l1_v, apart.l1_p, apart.l1_u, into.l1_rho, into.l1_v})
            row.push_back(report::percent(error));
        table.row(row);
    }
    run.claim("expansion-best", [&] {
        return apart_errors[2] < std::min(apart_errors[0], apart_errors[1]) &&
               vacuum_errors[2] < std::min(vacuum_errors[0], vacuum_errors[1]);
    });
    rho.legend.shown = false;
    u.legend.shown = false;
    empty.legend.outside = true;
    run.save(figure);
    run.fill("expansion", table.markdown());
}

}  // namespace sph::shocks
