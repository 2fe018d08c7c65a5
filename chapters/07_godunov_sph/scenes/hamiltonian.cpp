#include "chapters/07_godunov_sph/scenes/hamiltonian.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "chapters/07_godunov_sph/volumes.hpp"
#include "common/core/integrators.hpp"
#include "common/core/march.hpp"
#include "common/core/particles.hpp"

namespace sph::godunov {
namespace {

using Wide = ConvolvedGaussian<1>;
using Beads = Particles<1, Position, Velocity, Acceleration>;
constexpr double farthest = 6;  // spacings, beyond which a Gaussian of h = 1 is nothing
constexpr int places = 8;       // of the quadrature in a spacing: its error is below rounding
constexpr double h = 1, least = 1e-9;

/// What a volume rule reads of i, and of eight neighbours.
template <class T>
struct BeadSeen {
    T rho, h;
    Vec<T, 1> drho_dx;
};

class Ring {
  public:
    Ring(const WaveWithoutRiemann& scene, PairForce force)
        : scene_{scene}, force_{force}, length_{static_cast<double>(scene.n)} {
        beads_.resize(scene.n);
        for (std::size_t i = 0; i < scene.n; ++i) {
            const double place = static_cast<double>(i) + 0.5;
            beads_.x[0][i] = place;
            beads_.v[0][i] = scene.amplitude * std::sin(2 * std::numbers::pi * place / length_);
        }
    }
    Beads& beads() { return beads_; }

    void rates() {
        std::fill(beads_.dv_dt[0].begin(), beads_.dv_dt[0].end(), 0.0);
        if (force_ == PairForce::integral) return by_quadrature();
        by_pairs();
    }
    double kinetic() const {
        double sum = 0;
        for (const double v : beads_.v[0]) sum += 0.5 * v * v;
        return sum;
    }
    double energy() const {
        double sum = 0;
        for (std::size_t k = 0; k < places * scene_.n; ++k)
            sum +=
                std::pow(density(place_of(k)), scene_.gamma) / (scene_.gamma * (scene_.gamma - 1)) / places;
        return kinetic() + sum;
    }

  private:
    static double place_of(std::size_t k) { return static_cast<double>(k) / places; }
    template <class Visit>
    void near(double place, double reach, Visit&& visit) const {
        for (std::size_t j = 0; j < scene_.n; ++j) {
            const double far = place - beads_.x[0][j], apart = far - length_ * std::round(far / length_);
            if (std::abs(apart) < reach) visit(j, apart);
        }
    }
    double density(double place) const {
        double sum = 0;
        near(place, farthest, [&](std::size_t, double apart) { sum += Wide::W(std::abs(apart), h); });
        return sum;
    }
    /// m dv_i/dt = - dE/dx_i = integral of (u + P/rho) dW/dx(x - x_i) dx.
    void by_quadrature() {
        for (std::size_t k = 0; k < places * scene_.n; ++k) {
            const double place = place_of(k);
            const double enthalpy = std::pow(density(place), scene_.gamma - 1) / (scene_.gamma - 1);
            near(place, farthest, [&](std::size_t i, double apart) {
                beads_.dv_dt[0][i] += enthalpy * apart * Wide::F(std::abs(apart), h) / places;
            });
        }
    }
    void by_pairs() {
        Column rho(scene_.n), slope(scene_.n, 0);
        for (std::size_t i = 0; i < scene_.n; ++i) {
            rho[i] = density(beads_.x[0][i]);
            near(beads_.x[0][i], farthest,
                 [&](std::size_t, double apart) { slope[i] += apart * Wide::F(std::abs(apart), h); });
        }
        const auto seen = [&](auto of_i, std::size_t i) {
            return BeadSeen<decltype(of_i)>{rho[i], h, {slope[i]}};
        };
        for (std::size_t i = 0; i < scene_.n; ++i) {
            near(beads_.x[0][i], farthest * std::numbers::sqrt2, [&](std::size_t j, double apart) {
                if (std::abs(apart) < least) return;
                const Vec<Tile, 1> n{Tile{apart > 0 ? 1.0 : -1.0}};
                const Between face =
                    CubicVolume{}.face(seen(0.0, i), seen(Tile{0.0}, j), n, Tile{std::abs(apart)}, Wide{});
                const double P = 0.5 * (pressure(rho[i]) + pressure(rho[j]));
                beads_.dv_dt[0][i] -= P * face.area[0] * n[0][0];
            });
        }
    }
    double pressure(double rho) const { return std::pow(rho, scene_.gamma) / scene_.gamma; }

    WaveWithoutRiemann scene_;
    PairForce force_;
    double length_;
    Beads beads_;
};

}  // namespace

double energy_change(const WaveWithoutRiemann& scene, PairForce force) {
    Ring ring{scene, force};
    app::Team alone{1};
    Motion motion{alone};
    motion.evolve<Position, Velocity>(ring.beads()).evolve<Velocity, Acceleration>(ring.beads());
    KickDriftKick leapfrog{motion, [&](double) { ring.rates(); }};
    const double kinetic = ring.kinetic(), before = ring.energy();
    double t = 0, largest = 0;
    march(leapfrog, t,
          {.end = scene.periods * static_cast<double>(scene.n),
           .steps = std::lround(scene.periods * static_cast<double>(scene.steps))},
          [&](double) { largest = std::max(largest, std::abs(ring.energy() - before)); });
    return largest / kinetic;
}

}  // namespace sph::godunov
