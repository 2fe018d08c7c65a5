#include <algorithm>
#include <cmath>

#include "chapters/06_finite_particle_method/scenes/burgers.hpp"
#include "common/exact/burgers.hpp"

namespace sph::fpm {

/// Runge and Kutta's method with a thousand steps for each unit of time, to 1e-9.
Column exact_path(double viscosity, double X, const Column& times) {
    const exact::Burgers exact{viscosity};
    Column path;
    double x = X, t = 0;
    for (const double end : times) {
        const long steps = std::max(1L, std::lround(1000 * (end - t)));
        const double dt = (end - t) / static_cast<double>(steps);
        for (long k = 0; k < steps; ++k, t += dt) {
            const double a = exact.velocity(x, t), b = exact.velocity(x + dt / 2 * a, t + dt / 2),
                         c = exact.velocity(x + dt / 2 * b, t + dt / 2),
                         e = exact.velocity(x + dt * c, t + dt);
            x += dt / 6 * (a + 2 * b + 2 * c + e);
        }
        path.push_back(x);
    }
    return path;
}

}  // namespace sph::fpm
