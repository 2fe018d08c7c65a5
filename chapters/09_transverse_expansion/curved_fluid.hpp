#pragma once
#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "chapters/08_landau_model/entropic_fluid.hpp"
#include "chapters/09_transverse_expansion/metrics.hpp"

/// Chapter 8's fluid in coordinates of one's choice.
namespace sph {

/// sqrt(-g) P: what takes the place of the pressure in chapter 3's sums.
struct WeighedPressure {
    static constexpr std::string_view name = "sqrt(-g) P";
    template <class T, int>
    struct In {
        T p_tilde{};
    };
};
/// Chapter 3's density and forces, counted in entropy by volume of coordinates.
struct OfCurvedEntropy {
    using Amount = Entropy;
    using PerVolume = EntropyDensity;
    template <class Effect>
    using Counted = Renamed<Effect, As<Mass, Entropy>, As<Density, EntropyDensity>,
                            As<Acceleration, MomentumRate>, As<Pressure, WeighedPressure>>;
};

/// With s*_i = sum_j nu_j W_ij = sqrt(-g) s u^0 (Chen 2017, 314; the kernel's integral over coordinates is 1,
/// 317) the action leads to
///     dq_i/dt = - sum_j nu_j [P~_i/(Omega_i s*_i^2) grad_i W_ij(h_i) + P~_j/(Omega_j s*_j^2) grad_i
///     W_ij(h_j)]
///               + the effects of the metric,   P~ = sqrt(-g) P   (322),
/// with q_a = w g_a u^a, w = (eps + P)/s (323), and dx^a/dt = u^a/u^0. Entropy does not evolve; momentum is
/// conserved to rounding where the metric has no effects. Positions are coordinates; Velocity is dx^a/dt and
/// FourVelocity is u^a.
template <class Resolution, class Fluid, class Metric, class Boundary = Free>
class CurvedFluid
    : public Smoothed<Integrated, Resolution, Boundary,
                      Union<List<FourVelocity, MomentumPerCharge, MomentumRate, WeighedPressure>,
                            typename Metric::Columns>> {
    using Base = Smoothed<Integrated, Resolution, Boundary,
                          Union<List<FourVelocity, MomentumPerCharge, MomentumRate, WeighedPressure>,
                                typename Metric::Columns>>;

  public:
    using Base::d;
    using Base::particles;
    static_assert(Metric::d == d);

    CurvedFluid(std::size_t n, Resolution resolution, Fluid fluid, Metric metric, Boundary boundary,
                int threads)
        : Base{n, std::move(resolution), std::move(boundary), threads}, fluid_{fluid}, metric_{metric} {
        Motion& motion = this->motion_ = Motion{this->team()};
        motion.evolve<Position, Velocity>(particles).template evolve<MomentumPerCharge, MomentumRate>(
            particles);
    }

    /// From nu, s* and u^a.
    void start(double t) override {
        auto& p = particles;
        time_ = t;
        this->resolution_.start(p);
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto metric = metric_.at(t, place(i));
            double U2 = 0;
            for (std::size_t a = 0; a < d; ++a) U2 += metric.g[a] * square(p.U[a][i]);
            const double w = fluid_.enthalpy(resting(metric, p.s_star[i]) / std::sqrt(1 + U2));
            for (std::size_t a = 0; a < d; ++a) p.q[a][i] = w * metric.g[a] * p.U[a][i];
        }
    }
    /// s*, h, velocity and pressure at the present positions and momenta.
    void resolve(double t) override {
        time_ = t;
        this->find_density(t);
        this->require_physical_columns(List<MomentumPerCharge, EntropyDensity>{}, t);
        this->team().parallel_for(particles.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) recover_velocity(i, t);
        });
    }
    void rates(double t) override {
        resolve(t);
        std::apply(
            [&](const auto&... effects) {
                this->sum(Effects{typename Resolution::Force{}, effects...});
            },
            metric_.effects(t));
    }

    double resolved_at() const { return time_; }
    const Fluid& fluid() const { return fluid_; }
    const Metric& metric() const { return metric_; }
    /// Gamma = sqrt(1 + g_a u^a u^a), the Lorentz factor that somebody at rest in the coordinates sees.
    double lorentz(std::size_t i, double t) const {
        const auto metric = metric_.at(t, place(i));
        double U2 = 0;
        for (std::size_t a = 0; a < d; ++a) U2 += metric.g[a] * square(particles.U[a][i]);
        return std::sqrt(1 + U2);
    }
    /// Entropy density of matter at rest, at a resolved state.
    double entropy(std::size_t i, double t) const {
        return resting(metric_.at(t, place(i)), particles.s_star[i]) / lorentz(i, t);
    }
    /// sum nu (in the place of mass), sum nu q, and the sum of nu (w Gamma - P Gamma/(Gamma^2 s) ...) that is
    /// T^0_0 sqrt(-g): an energy, conserved only where the metric does not depend on time.
    Totals<d> totals() const override {
        const auto& p = particles;
        Totals<d> sum;
        for (std::size_t i = 0; i < p.size(); ++i) {
            sum.mass += p.nu[i];
            for (std::size_t a = 0; a < d; ++a) sum.momentum[a] += p.nu[i] * p.q[a][i];
        }
        return sum;
    }
    /// The time in which sound crosses an h, seen from the coordinates, at a state resolved at time t: along
    /// the motion a signal leaves its particle at v - (v - c_s)/(1 - v c_s), across it at c_s/Gamma. A length
    /// h of a coordinate counts as the least sqrt(g_a/g_00) h.
    double crossing_time(double t) const {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < particles.size(); ++i) {
            const auto metric = metric_.at(t, place(i));
            const double g = lorentz(i, t), v = std::sqrt((g - 1) * (g + 1)) / g;
            const double c = std::sqrt(fluid_.sound_speed_squared(resting(metric, particles.s_star[i]) / g));
            const double signal = c / g * std::max(1.0, 1 / (g * (1 - v * c)));
            double scale = metric.g[0];
            for (std::size_t a = 1; a < d; ++a) scale = std::min(scale, metric.g[a]);
            least = std::min(least, h(i) * std::sqrt(scale / metric.g_00) / signal);
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
    Vector<d> place(std::size_t i) const {
        Vector<d> x;
        for (std::size_t a = 0; a < d; ++a) x[a] = particles.x[a][i];
        return x;
    }
    /// s Gamma: the entropy by volume that somebody at rest in the coordinates sees.
    static double resting(const auto& metric, double s_star) {
        return s_star * std::sqrt(metric.g_00) / metric.volume;
    }
    // [recover]
    /// |q|^2 = q_a q_a/g_a is (w U)^2: chapter 8's one unknown, and a direction that is known.
    void recover_velocity(std::size_t i, double t) {
        auto& p = particles;
        const auto metric = metric_.at(t, place(i));
        double q2 = 0, U2 = 0;
        for (std::size_t a = 0; a < d; ++a) {
            q2 += square(p.q[a][i]) / metric.g[a];
            U2 += metric.g[a] * square(p.U[a][i]);
        }
        const double n = resting(metric, p.s_star[i]);
        const Recovered state = recover(std::sqrt(q2), n, fluid_, std::sqrt(U2));
        const double g = state.lorentz(), w = fluid_.enthalpy(n / g);
        for (std::size_t a = 0; a < d; ++a) {
            p.U[a][i] = p.q[a][i] / (w * metric.g[a]);
            p.v[a][i] = p.U[a][i] * std::sqrt(metric.g_00) / g;
        }
        p.p[i] = fluid_.pressure(n / g);
        p.p_tilde[i] = metric.volume * p.p[i];
    }
    // [end]

    Fluid fluid_;
    Metric metric_;
    double time_ = 0;
};

}  // namespace sph
