#pragma once
#include <algorithm>
#include <utility>

#include "chapters/03_euler_sph/gas.hpp"
#include "chapters/08_landau_model/recovery.hpp"
#include "common/core/renamed.hpp"

/// Relativistic SPH from the action: what evolves is momentum, and the forces are chapter 3's.
namespace sph {

/// nu: what a particle has of entropy, for good.
struct Entropy {
    static constexpr std::string_view name = "entropy";
    static constexpr bool positive = true;
    template <class T, int>
    struct In {
        T nu{};
    };
};
/// s* = lorentz s, by volume in the laboratory.
struct EntropyDensity {
    static constexpr std::string_view name = "entropy density in the laboratory";
    static constexpr bool positive = true;
    template <class T, int>
    struct In {
        T s_star{};
    };
};
/// q = w lorentz v, the momentum per unit of entropy (or per baryon)   (Chen 2017, 220).
struct MomentumPerCharge {
    static constexpr std::string_view name = "momentum per charge";
    static constexpr bool held = true;
    template <class T, int d>
    struct In {
        Vec<T, d> q{};
    };
};
struct MomentumRate {
    static constexpr std::string_view name = "rate of momentum per charge";
    template <class T, int d>
    struct In {
        Vec<T, d> dq_dt{};
    };
};
/// U = lorentz v.
struct FourVelocity {
    static constexpr std::string_view name = "four-velocity";
    template <class T, int d>
    struct In {
        Vec<T, d> U{};
    };
};
// [counted]
/// Chapter 3's density and pressure force, counted in entropy.
struct OfEntropy {
    using Amount = Entropy;
    using PerVolume = EntropyDensity;
    template <class Effect>
    using Counted =
        Renamed<Effect, As<Mass, Entropy>, As<Density, EntropyDensity>, As<Acceleration, MomentumRate>>;
};
// [end]

/// A fluid of constant entropy per charge, in the frame of the laboratory. With the entropy nu_i of a
/// particle and s*_i = sum_j nu_j W_ij (238), the action -sum nu (eps/s*) (225) leads to
///     dq_i/dt = - sum_j nu_j [P_i/(Omega_i s*_i^2) grad_i W_ij(h_i) + P_j/(Omega_j s*_j^2) grad_i W_ij(h_j)]
/// (237; with s* = lorentz s in its denominators, as 220 has it), which are the sums of chapter 3 with the
/// pressure at s = s*/lorentz. Only q -> v is new. Entropy is exact: it does not evolve. In one dimension.
template <class Resolution, class Fluid>
class EntropicFluid
    : public Smoothed<Integrated, Resolution, Free, List<FourVelocity, MomentumPerCharge, MomentumRate>> {
    using Base = Smoothed<Integrated, Resolution, Free, List<FourVelocity, MomentumPerCharge, MomentumRate>>;

  public:
    using Base::particles;
    static_assert(Base::d == 1, "momenta are recovered along one axis");

    EntropicFluid(std::size_t n, Resolution resolution, Fluid fluid, int threads)
        : Base{n, std::move(resolution), Free{}, threads}, fluid_{fluid} {
        Motion& motion = this->motion_ = Motion{this->team()};
        motion.evolve<Position, Velocity>(particles).template evolve<MomentumPerCharge, MomentumRate>(
            particles);
    }

    /// From nu, s* and v.
    void start(double) override {
        this->resolution_.start(particles);
        for (std::size_t i = 0; i < particles.size(); ++i) {
            const double v = particles.v[0][i], g = 1 / std::sqrt((1 - v) * (1 + v));
            particles.q[0][i] = fluid_.enthalpy(particles.s_star[i] / g) * g * v;
        }
    }
    // [rates]
    /// s*, h, velocity and pressure at the present positions and momenta.
    void resolve(double t) override {
        auto& p = particles;
        this->find_density(t);
        this->require_physical_columns(List<MomentumPerCharge, EntropyDensity>{}, t);
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Recovered state = recover(p.q[0][i], p.s_star[i], fluid_, p.U[0][i]);
            p.U[0][i] = state.U;
            p.v[0][i] = state.velocity();
            p.p[i] = fluid_.pressure(p.s_star[i] / state.lorentz());
        }
    }
    void rates(double t) override {
        resolve(t);
        this->sum(Effects{typename Resolution::Force{}});
    }
    // [end]

    double lorentz(std::size_t i) const { return std::sqrt(1 + particles.U[0][i] * particles.U[0][i]); }
    /// sum nu (in the place of mass), sum nu q, and sum nu T00/s*, T00 = (eps + P) lorentz^2 - P.
    Totals<1> totals() const override {
        const auto& p = particles;
        Totals<1> sum;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double g = lorentz(i), w = fluid_.enthalpy(p.s_star[i] / g);
            sum.mass += p.nu[i];
            sum.momentum[0] += p.nu[i] * p.q[0][i];
            sum.energy += p.nu[i] * (w * g - p.p[i] / p.s_star[i]);
        }
        return sum;
    }
    /// The time in which sound crosses an h, seen from the laboratory, at a resolved state: sound that runs
    /// against the flow leaves its particle at |v| - (|v| - c_s)/(1 - |v| c_s), so
    ///     min_i h_i (1 - |v_i| c_s)/(c_s (1 - v_i^2)).
    /// Near the vacuum h is small, but clocks are slow: the second factor wins.
    double crossing_time() const {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < particles.size(); ++i) {
            const double g = lorentz(i), c_s = std::sqrt(fluid_.sound_speed_squared(particles.s_star[i] / g));
            const double slow = 1 - std::abs(particles.v[0][i]) * c_s;
            least = std::min(least, h(i) * slow * g * g / c_s);
        }
        return least;
    }
    double h(std::size_t i) const {
        if constexpr (requires { particles.h[i]; }) {
            return particles.h[i];
        } else {
            return this->resolution_.h;
        }
    }

  private:
    Fluid fluid_;
};

}  // namespace sph
