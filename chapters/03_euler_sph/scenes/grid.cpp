#include "chapters/03_euler_sph/scenes/grid.hpp"

#include "chapters/03_euler_sph/scenes/lagrangian_grid.hpp"
#include "chapters/03_euler_sph/scenes/star.hpp"
#include "chapters/03_euler_sph/scenes/wave.hpp"

namespace sph::euler {
namespace {

/// The faces of a star at rest on a grid with P = K rho^2 and cells of mass m: from the outermost face
/// inwards the pressure must carry what lies outside; where that face lies follows from symmetry, by
/// bisection.
std::vector<double> faces_at_rest(const Column& m, double K) {
    const std::size_t cells = m.size();
    std::vector<double> x(cells + 1);
    const auto inner_end = [&](double edge) {
        x[cells] = edge;
        double P = 0.5 * m[cells - 1] * edge;
        for (std::size_t k = cells; k-- > 0;) {
            x[k] = x[k + 1] - m[k] / std::sqrt(P / K);
            if (k > 0) P = std::max(P + 0.5 * (m[k] + m[k - 1]) * x[k], 1e-300);
        }
        return x[0];
    };
    double low = 0.5, high = 1.5;
    for (int step = 0; step < 80; ++step) {
        const double middle = (low + high) / 2;
        (inner_end(middle) < -middle ? low : high) = middle;
    }
    return x;
}

/// sqrt(<x^2>), with the mass of each cell in its middle.
double spread(const LagrangianGrid<Quadratic>& grid) {
    double moment = 0, mass = 0;
    for (std::size_t k = 0; k < grid.m.size(); ++k) {
        moment += grid.m[k] * square((grid.x[k] + grid.x[k + 1]) / 2);
        mass += grid.m[k];
    }
    return std::sqrt(moment / mass);
}

}  // namespace

report::Lap run_grid_wave(std::size_t n) {
    WaveScene scene;
    scene.n = n;
    LagrangianGrid<Polytrope> grid{scene.state(), 1, 0};
    for (std::size_t k = 0; k < n; ++k) {
        grid.x.push_back(static_cast<double>(k) * scene.spacing());
        grid.v.push_back(scene.velocity(grid.x.back(), 0));
        grid.m.push_back(scene.spacing());
    }
    double t = 0, worst = 0;
    const long steps = std::lround(std::ceil(1 / (scene.courant * scene.spacing())));
    const Marched done = march(grid, t, {.end = 1, .steps = steps}, [&](double now) {
        double error = 0, size = 0;
        for (std::size_t k = 0; k < n; ++k) {
            error += std::abs(grid.v[k] - scene.velocity(grid.x[k], now));
            size += std::abs(scene.velocity(grid.x[k], 0));
        }
        worst = std::max(worst, error / size);
    });
    return {worst, done.seconds};
}

report::Lap run_grid_star(std::size_t n, double A_0) {
    StarScene scene;
    scene.n = n;
    const StarPoints points = star_points(scene);
    const exact::ToyStar star = scene.exact(A_0);
    LagrangianGrid<Quadratic> grid{{scene.state().K}, 0, 1};
    grid.m = points.m;
    grid.x = faces_at_rest(grid.m, scene.state().K);
    for (const double x : grid.x) grid.v.push_back(A_0 * x);
    double smallest = 1;
    for (int k = 0; k <= 1000; ++k) smallest = std::min(smallest, star.at(star.period() * k / 1000).radius);
    const double dt = 0.3 * points.width[n / 2] * std::sqrt(2.0) * std::pow(smallest, 1.5);
    const long steps = std::lround(std::ceil(star.period() / dt));
    plot::Values times, radius;
    double t = 0;
    long step = 0;
    const Marched done = march(grid, t, {.end = star.period(), .steps = steps}, [&](double now) {
        if (++step % std::max(1L, steps / 100) != 0) return;
        times.push_back(now);
        radius.push_back(std::sqrt(5.0) * spread(grid));
    });
    report::Lap lap{0, done.seconds};
    for (std::size_t k = 0; k < times.size(); ++k)
        lap.error = std::max(lap.error, std::abs(radius[k] / star.at(times[k]).radius - 1));
    return lap;
}

}  // namespace sph::euler
