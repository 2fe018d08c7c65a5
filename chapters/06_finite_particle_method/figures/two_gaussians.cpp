#include "chapters/06_finite_particle_method/scenes/interpolation.hpp"
#include "chapters/06_finite_particle_method/scenes/line_methods.hpp"
#include "common/plot/looks.hpp"

/// Values and derivatives of two Gaussians on 1000 particles (Mota, Chen & Qian 2017, figure 1).
namespace sph::fpm {
namespace {

using consistency::Where;

ParticleSet particles(Arrangement arrangement) {
    ParticleSet set;
    set.arrangement = arrangement, set.per_side = 1000;
    set.h_over_dx = 2;  // h = 0.002
    set.jitter = 0.3;
    return set;
}

void draw(plot::Panel& panel, std::size_t k, const std::vector<std::string>& names) {
    constexpr double from = 0.97;
    for (const std::string& name : names) {
        const auto e = interpolate<1>(particles(Arrangement::random), two_gaussians<1>, {name, 2});
        plot::Values x, y;
        for (std::size_t i = 0; i < e.inside.size(); ++i) {
            if (e.x[0][i] > from) x.push_back(e.x[0][i]), y.push_back(e.estimated[k][i]);
        }
        panel.points(x, y, plot::dots(still_methods()[name].styled(), 5));
    }
    plot::draw_exact(panel, from, 1, [k](double x) { return two_gaussians<1>({x}, k); });
}

}  // namespace

void two_gaussians_figure(report::Run& run) {
    plot::Figure figure{"two-gaussians", 1, 3};
    draw(figure.at(0, 0).titled("value").labels("$x$", "$f$"), 0, {"sph", "cspm", "sfpm"});
    draw(figure.at(0, 1).titled("slope").labels("$x$", "$f$′"), 1, {"cspm", "fpm", "sfpm"});
    draw(figure.at(0, 2).titled("curvature").labels("$x$", "$f$″"), 2, {"cspm", "fpm", "sfpm"});
    report::Table table{{"member", "even: $`f`$", "$`f'`$", "jittered: $`f`$", "$`f'`$", "random: $`f`$",
                         "$`f'`$", "$`f''`$"}};
    std::map<std::string, std::array<double, 3>> random;
    for (const char* name : {"sph", "cspm", "fpm", "sfpm", "taylor"}) {
        std::vector<std::string> row{still_methods()[name].label};
        for (const Arrangement arrangement :
             {Arrangement::even, Arrangement::jittered, Arrangement::random}) {
            const auto e = interpolate<1>(particles(arrangement), two_gaussians<1>, {name, 2});
            const std::string where = arrangement_names()[static_cast<std::size_t>(arrangement)];
            for (int degree = 0; degree <= 2; ++degree) {
                const double error = e.error(degree, Where::everywhere);
                random[name][static_cast<std::size_t>(degree)] = error;
                run.record(std::string{name} + " " + where, 1000,
                           {{degree == 0   ? "l2_f"
                             : degree == 1 ? "l2_slope"
                                           : "l2_curvature",
                             error}});
                if (degree < 2 || arrangement == Arrangement::random)
                    row.push_back(error == 0 ? "0" : report::number(error, 2));
            }
        }
        table.row(row);
    }
    run.fill("two-gaussians", table.markdown());
    run.claim(
        "orders-of-magnitude",
        [&] {
            return random["sph"][0] > 20 * random["cspm"][0] && random["cspm"][0] > 100 * random["sfpm"][0] &&
                   random["cspm"][1] > 5 * random["sfpm"][1] && random["sph"][1] > 0.1 &&
                   random["fpm"][0] < 2 * random["sfpm"][0] && random["cspm"][2] > 5 * random["sfpm"][2];
        },
        report::Needs::any_run);
    run.save(figure);
}

}  // namespace sph::fpm
