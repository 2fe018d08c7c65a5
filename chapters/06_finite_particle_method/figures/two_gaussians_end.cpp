#include "chapters/06_finite_particle_method/scenes/interpolation.hpp"
#include "chapters/06_finite_particle_method/scenes/line_methods.hpp"
#include "common/plot/looks.hpp"

/// The two Gaussians near the right end, on random particles: where repaired estimates differ.
namespace sph::fpm {
namespace {

void draw_near_end(plot::Panel& panel, std::size_t k, const std::vector<std::string>& names) {
    constexpr double from = 0.97;
    for (const std::string& name : names) {
        const auto e = interpolate<1>(thousand(Arrangement::random), two_gaussians<1>, {name, 2});
        plot::Values x, y;
        for (std::size_t i = 0; i < e.inside.size(); ++i) {
            if (e.x[0][i] > from) x.push_back(e.x[0][i]), y.push_back(e.estimated[k][i]);
        }
        panel.points(x, y, plot::dots(still_methods()[name].styled(), 5));
    }
    plot::draw_exact(panel, from, 1, [k](double x) { return two_gaussians<1>({x}, k); });
}

}  // namespace

void two_gaussians_end(report::Run& run) {
    plot::Figure figure{"two-gaussians-end", 1, 3};
    draw_near_end(figure.at(0, 0).titled("value").labels("$x$", "$f$"), 0, {"sph", "cspm", "sfpm"});
    draw_near_end(figure.at(0, 1).titled("slope").labels("$x$", "$f$′"), 1, {"cspm", "fpm", "sfpm"});
    draw_near_end(figure.at(0, 2).titled("curvature").labels("$x$", "$f$″"), 2, {"cspm", "fpm", "sfpm"});
    run.save(figure);
}

}  // namespace sph::fpm
