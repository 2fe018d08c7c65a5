#pragma once
#include <algorithm>
#include <utility>

#include "chapters/03_euler_sph/gas.hpp"
#include "chapters/08_landau_model/recovery.hpp"

/// Relativistic SPH from the action: what evolves is momentum, and the forces are chapter 3's.
namespace sph {

/// q = w lorentz v, the momentum per unit of entropy (or per baryon)   (Chen 2017, 220).
struct Momentum {
    static constexpr std::string_view name = "momentum per charge";
    template <class T, int d>
    struct In {
        Vec<T, d> q{};
    };
};
/// lorentz v.
struct FourVelocity {
    static constexpr std::string_view name = "four-velocity";
    template <class T, int d>
    struct In {
        Vec<T, d> u{};
    };
};

/// A fluid of constant entropy per charge, in the frame of the laboratory. With the entropy nu_i of a
/// particle as its mass m and s*_i = sum_j nu_j W_ij (238) as its rho, the action -sum nu (eps/s*) (225)
/// leads to
///     dq_i/dt = - sum_j nu_j [P_i/(Omega_i s*_i^2) grad_i W_ij(h_i) + P_j/(Omega_j s*_j^2) grad_i W_ij(h_j)]
/// (237; with s* = lorentz s in its denominators, as 220 has it), which are the sums of chapter 3 with the
/// pressure at s = s*/lorentz. Only q -> v is new. Entropy is exact: it does not evolve. In one dimension.
template <class Resolution, class Fluid>
class EntropicFluid {
  public:
    static constexpr int d = Resolution::Kernel::dimension;
    static_assert(d == 1, "momenta are recovered along one axis");
    using Motion = Equations<Evolve<Position, Velocity>, Evolve<Momentum, Acceleration>>;
    using P = ParticlesOf<
        d, Union<List<Position, Velocity, FourVelocity, Momentum, Acceleration, Mass, Density, Pressure>,
                 typename Resolution::Columns>>;

    P particles;

    EntropicFluid(std::size_t n, Resolution resolution, Fluid fluid, int threads)
        : particles{n}, resolution_{std::move(resolution)}, fluid_{fluid}, neighbours_{Free{}, threads} {}

    /// s*, h, velocity and pressure at the present positions and momenta.
    void resolve(double t) {
        P& p = particles;
        try {
            resolution_.resolve(p, neighbours_);
        } catch (const Unstable& failure) {
            throw Unstable{t, failure.particle, failure.quantity, failure.value};
        } catch (const std::invalid_argument&) {  // a position or h that is not a number: say when and whose
            require_physical(p, t, typename P::Names{});
            throw;
        }
        require_physical(p, t, List<Momentum, Density>{});
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Recovered state = recover(p.q[0][i], p.rho[i], fluid_, p.u[0][i]);
            p.u[0][i] = state.u;
            p.v[0][i] = state.velocity();
            p.p[i] = fluid_.pressure(p.rho[i] / state.lorentz());
        }
    }
    /// The rates of position and momentum; for integrators.
    void rates(double t) {
        resolve(t);
        sum_over_neighbours(particles, neighbours_, resolution_.smoothing(),
                            Effects{typename Resolution::Force{}});
    }

    double lorentz(std::size_t i) const { return std::sqrt(1 + particles.u[0][i] * particles.u[0][i]); }
    /// sum nu T00/s*, T00 = (eps + P) lorentz^2 - P, at a resolved state.
    double energy() const {
        const P& p = particles;
        double sum = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double g = lorentz(i), s = p.rho[i] / g;
            sum += p.m[i] * (fluid_.enthalpy(s) * g - p.p[i] / p.rho[i]);
        }
        return sum;
    }
    /// sum nu q.
    double momentum() const {
        double sum = 0;
        for (std::size_t i = 0; i < particles.size(); ++i) sum += particles.m[i] * particles.q[0][i];
        return sum;
    }
    /// The time in which sound crosses an h, seen from the laboratory, at a resolved state: sound that runs
    /// against the flow leaves its particle at |v| - (|v| - c_s)/(1 - |v| c_s), so
    ///     min_i h_i (1 - |v_i| c_s)/(c_s (1 - v_i^2)).
    /// Near the vacuum h is small, but clocks are slow: the second factor wins.
    double crossing_time() const {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < particles.size(); ++i) {
            const double g = lorentz(i), c_s = sound_speed(i);
            const double slow = 1 - std::abs(particles.v[0][i]) * c_s;
            least = std::min(least, h(i) * slow * g * g / c_s);
        }
        return least;
    }
    double h(std::size_t i) const {
        if constexpr (Has<P, SmoothingLength>) {
            return particles.h[i];
        } else {
            return resolution_.h;
        }
    }
    double sound_speed(std::size_t i) const {
        return std::sqrt(fluid_.sound_speed_squared(particles.rho[i] / lorentz(i)));
    }
    Counters& counters() { return neighbours_.counters(); }

  private:
    Resolution resolution_;
    Fluid fluid_;
    Neighbours<d> neighbours_;
};

}  // namespace sph
