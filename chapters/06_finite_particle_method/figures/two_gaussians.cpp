#include <map>

#include "chapters/06_finite_particle_method/scenes/interpolation.hpp"
#include "chapters/06_finite_particle_method/scenes/line_methods.hpp"
#include "common/plot/looks.hpp"

/// Values and derivatives of two Gaussians on 1000 particles (Mota, Chen & Qian 2017, figure 1, all four
/// panels; Chen 2017, figures 21 and 22).
namespace sph::fpm {
namespace {

using consistency::Where;

struct Row {
    std::string name, label;
    Choice choice;
};
const std::vector<Row> shown{
    {"sph", "SPH", {"sph", 2}}, {"cspm", "CSPM", {"cspm", 2}}, {"fpm-1", "FPM, order 1", {"fpm", 1}},
    {"fpm", "FPM", {"fpm", 2}}, {"sfpm", "SFPM", {"sfpm", 2}}, {"taylor", "Taylor SPH", {"taylor", 2}}};

void draw(plot::Panel& panel, const Row& row, Arrangement arrangement, std::size_t k) {
    const auto e = interpolate<1>(thousand(arrangement), two_gaussians<1>, row.choice);
    plot::Style look = plot::dots(still_methods()[row.choice.member].styled(), 3);
    look.label = row.label;
    panel.titled(row.label + ", " + arrangement_names()[static_cast<std::size_t>(arrangement)]);
    panel.labels("$x$", k == 0 ? "$f$" : "$f$′").x_range(0, 1);
    panel.points(e.x[0], e.estimated[k], look);
    plot::draw_exact(panel, 0, 1, [k](double x) { return two_gaussians<1>({x}, k); });
    panel.legend.shown = false;
    k == 0 ? panel.y_range(0, 1.4) : panel.y_range(-10, 10);
}

/// The largest error of the value, and that of the last particle, on even particles: relative to f there.
struct EndsOfSph {
    double inside = 0, last = 0;
};
EndsOfSph ends_of_sph() {
    const auto e = interpolate<1>(thousand(Arrangement::even), two_gaussians<1>, {"sph", 2});
    EndsOfSph found;
    for (std::size_t i = 0; i < e.inside.size(); ++i) {
        const double off = std::abs(e.estimated[0][i] / e.exact[0][i] - 1);
        if (e.inside[i]) found.inside = std::max(found.inside, off);
        found.last = off;
    }
    return found;
}

}  // namespace

void two_gaussians_figure(report::Run& run) {
    plot::Figure figure{"two-gaussians", 2, 3};
    for (const int row : {0, 1}) {
        const Row& who = shown[row == 0 ? 0 : 2];
        draw(figure.at(row, 0), who, Arrangement::even, 0);
        draw(figure.at(row, 1), who, Arrangement::random, 0);
        draw(figure.at(row, 2), who, Arrangement::random, 1);
    }
    report::Table table{{"member", "even: $`f`$", "$`f'`$", "jittered: $`f`$", "$`f'`$", "random: $`f`$",
                         "$`f'`$", "$`f''`$"}};
    std::map<std::string, std::array<double, 3>> random;
    for (const Row& who : shown) {
        std::vector<std::string> row{who.label};
        for (const Arrangement arrangement :
             {Arrangement::even, Arrangement::jittered, Arrangement::random}) {
            const auto e = interpolate<1>(thousand(arrangement), two_gaussians<1>, who.choice);
            const std::string where = arrangement_names()[static_cast<std::size_t>(arrangement)];
            for (int degree = 0; degree <= 2; ++degree) {
                if (degree == 2 && who.choice.order < 2) continue;
                const double error = e.error(degree, Where::everywhere);
                random[who.name][static_cast<std::size_t>(degree)] = error;
                run.record(who.name + " " + where, 1000,
                           {{degree == 0   ? "l2_f"
                             : degree == 1 ? "l2_slope"
                                           : "l2_curvature",
                             error}});
                if (degree < 2 || arrangement == Arrangement::random)
                    row.push_back(error == 0 ? "0" : report::number(error, 2));
            }
        }
        row.resize(8, "–");
        table.row(row);
    }
    run.fill("two-gaussians", table.markdown());
    const EndsOfSph sph = ends_of_sph();
    run.record("sph even", 1000, {{"end_off", sph.last}, {"inside_off", sph.inside}});
    run.fill("end-off", report::number(100 * sph.last, 2));
    run.claim(
        "boundary-fails", [&] { return sph.last > 0.1 && sph.inside < 2e-3; }, report::Needs::any_run);
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
