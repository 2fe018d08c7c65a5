#include "chapters/07_godunov_sph/scenes/uniform_pressure.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "chapters/04_artificial_viscosity/scenes/tube_lattice.hpp"
#include "chapters/07_godunov_sph/volumes.hpp"

namespace sph::godunov {
namespace {

constexpr double reach = 8;  // spacings, beyond which a Gaussian of h = 1 is nothing
using Kernel = ConvolvedGaussian<1, 6>;

/// What a volume rule reads of i, and of eight neighbours.
template <class T>
struct Seen {
    T rho, h;
    Vec<T, 1> drho_dx;
};

class Line {
  public:
    explicit Line(const Resting& scene) : length_{static_cast<double>(scene.n)} {
        if (!(scene.jitter >= 0 && scene.jitter < 0.5)) throw std::invalid_argument{"jitter outside 0..0.5"};
        std::mt19937_64 random{scene.seed};
        for (std::size_t i = 0; i < scene.n; ++i)
            x.push_back(static_cast<double>(i) + 0.5 + scene.jitter * shocks::random_shift(random));
        h.assign(scene.n, 1);
    }
    Column x, h, rho, slope;

    /// Calls visit(j, x_i - x_j) for all neighbours of a place.
    template <class Visit>
    void near(double place, Visit&& visit) const {
        for (std::size_t j = 0; j < x.size(); ++j) {
            const double far = place - x[j], apart = far - length_ * std::round(far / length_);
            if (std::abs(apart) < reach) visit(j, apart);
        }
    }
    /// Density with each particle's h, and its fitted slopes.
    void resolve() {
        rho.assign(x.size(), 0), slope.assign(x.size(), 0);
        for (std::size_t i = 0; i < x.size(); ++i)
            near(x[i], [&](std::size_t, double apart) { rho[i] += Kernel::W(std::abs(apart), h[i]); });
        for (std::size_t i = 0; i < x.size(); ++i) {
            double M = 0, S = 0;
            near(x[i], [&](std::size_t j, double apart) {
                const double weight = Kernel::F(std::abs(apart), h[i]) / rho[j];
                M -= weight * apart * apart, S -= weight * (rho[i] - rho[j]) * apart;
            });
            slope[i] = S / M;
        }
    }
    /// h_i = 1/rho_i, solved by repetition: at h near the spacing rho hardly depends on h.
    void own_h() {
        for (int k = 0; k < 50; ++k) {
            resolve();
            for (std::size_t i = 0; i < x.size(); ++i) h[i] = 1 / rho[i];
        }
        resolve();
    }
    /// Of the accelerations that acceleration(i, j, x_ij) sums.
    template <class Of>
    double rms(Of&& acceleration) const {
        double squares = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            double sum = 0;
            near(x[i], [&](std::size_t j, double apart) { sum += acceleration(i, j, apart); });
            squares += sum * sum;
        }
        return std::sqrt(squares / static_cast<double>(x.size()));
    }
    template <class Volumes>
    double rms_of(const Volumes& volumes) const {
        return rms([&](std::size_t i, std::size_t j, double apart) {
            if (i == j) return 0.0;
            const Seen<double> of_i{rho[i], h[i], {slope[i]}};
            const Seen<Tile> of_j{rho[j], h[j], {Tile{slope[j]}}};
            const double n = apart > 0 ? 1 : -1;
            const Between face = volumes.face(of_i, of_j, Vec<Tile, 1>{Tile{n}}, std::abs(apart), Kernel{});
            return -face.area[0] * n;
        });
    }
    /// - sum_j P integral 1/rho^2 [d/dx_i - d/dx_j] W_i W_j: so many points per spacing suffice for the
    /// trapezoidal rule to be exact to rounding, as for all smooth periodic functions.
    double rms_of_integral() const {
        constexpr int points = 16;
        Column pull(x.size(), 0);
        for (std::size_t k = 0; k < points * x.size(); ++k) {
            const double place = static_cast<double>(k) / points;
            double density = 0, rise = 0;
            near(place, [&](std::size_t, double apart) {
                density += Kernel::W(std::abs(apart), 1.0);
                rise += apart * Kernel::F(std::abs(apart), 1.0);
            });
            near(place, [&](std::size_t i, double apart) {
                const double r = std::abs(apart);
                pull[i] += (apart * Kernel::F(r, 1.0) * density - Kernel::W(r, 1.0) * rise) /
                           (density * density * points);
            });
        }
        double squares = 0;
        for (const double one : pull) squares += one * one;
        return std::sqrt(squares / static_cast<double>(x.size()));
    }

  private:
    double length_;
};

}  // namespace

RestingForces resting_forces(const Resting& scene) {
    Line line{scene};
    line.resolve();
    RestingForces found;
    found.sph = line.rms([&](std::size_t i, std::size_t j, double apart) {
        const double both = 1 / (line.rho[i] * line.rho[i]) + 1 / (line.rho[j] * line.rho[j]);
        return -both * apart * Kernel::F(std::abs(apart), 1.0);
    });
    found.linear = line.rms_of(LinearVolume{});
    found.cubic = line.rms_of(CubicVolume{});
    found.quadrature = line.rms_of_integral();
    line.own_h();
    found.halves = line.rms_of(CubicVolume{});
    found.varying = line.rms_of(GeometricVolume{});
    return found;
}

Pairing pairing_under_tension() {
    constexpr double shift = 1e-5;
    Line line{{.n = 64, .jitter = 0}};
    for (std::size_t i = 0; i < line.x.size(); ++i) line.x[i] += i % 2 == 0 ? -shift : shift;
    line.resolve();
    Pairing found;
    found.sph = line.rms([&](std::size_t i, std::size_t j, double apart) {
        const double both = 1 / (line.rho[i] * line.rho[i]) + 1 / (line.rho[j] * line.rho[j]);
        return both * apart * Kernel::F(std::abs(apart), 1.0);
    });
    found.linear = line.rms_of(LinearVolume{}), found.cubic = line.rms_of(CubicVolume{});
    return {found.sph / shift, found.linear / shift, found.cubic / shift};
}

Partition partition(const Resting& scene) {
    Line line{scene};
    line.resolve();
    const auto velocity = [](double x) { return std::sin(2 * std::numbers::pi * x / 12); };
    Partition found;
    constexpr double from = 4, to = 16;
    constexpr int points = 480;
    for (int k = 0; k <= points; ++k) {
        const double place = from + (to - from) * k / points;
        double density = 0, sum = 0, flux = 0;
        line.near(place, [&](std::size_t j, double apart) {
            const double W = Kernel::W(std::abs(apart), 1.0);
            density += W, sum += W / line.rho[j], flux += W * velocity(line.x[j]);
        });
        found.x.push_back(place), found.exact.push_back(1), found.approximate.push_back(sum);
        found.field.push_back(flux / density);
    }
    for (const double place : line.x) {
        if (place > from && place < to)
            found.particles.push_back(place), found.velocities.push_back(velocity(place));
    }
    return found;
}

}  // namespace sph::godunov
