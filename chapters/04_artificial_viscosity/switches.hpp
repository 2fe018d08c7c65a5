#pragma once
#include <algorithm>
#include <cmath>

#include "chapters/04_artificial_viscosity/reconstruction.hpp"

/// Where is the shock? Detectors look at the flow once a step, and leave what viscosities and conduction
/// read. A detector has Columns; Slopes, the gradients that it needs; and, where it has something to do,
/// start(particles), measure(particles) after the gradients, and evolve(particles, dt) at a step's end.
namespace sph {

/// Looks at nothing.
struct NoDetector {
    using Columns = List<>;
    using Slopes = List<>;
};

/// The gradients for ReconstructedViscosity and ContactSpeed.
struct FlowSlopes {
    using Columns = List<VelocityGradient, PressureGradient>;
    using Slopes = List<VelocityGradient, PressureGradient>;
};

/// The viscous pressures of von Neumann & Richtmyer (1950), q = rho (a h div v)^2, and the bulk viscosity, q
/// = rho b h c_s |div v|, where div v < 0. Chen 2017, section 1.10, shows both (figure 8) without their
/// formulas; these are the classical ones.
struct BulkDetector {
    double a = 2, b = 0;
    static constexpr auto knobs() {
        return std::tuple{Knob{"a", &BulkDetector::a, {0, 10}, "von Neumann and Richtmyer's factor"},
                          Knob{"b", &BulkDetector::b, {0, 10}, "factor of the bulk viscosity"}};
    }
    using Columns = List<VelocityGradient, ViscousPressure>;
    using Slopes = List<VelocityGradient>;
    template <class P>
    void measure(P& p) const {
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto row = load<P::d>(p, i, List<VelocityGradient>{});
            const double fall = p.h[i] * std::max(-divergence(row.dv_dx), 0.0);
            p.q[i] = p.rho[i] * fall * (a * a * fall + b * p.c_s[i]);
        }
    }
};

/// The strength of a particle's viscosity.
struct ViscosityAlpha {
    static constexpr std::string_view name = "alpha";
    template <class T, int>
    struct In {
        T alpha{};
    };
    static auto of(const auto& a) { return a.alpha; }
};

/// d alpha/dt = -(alpha - alpha_0)/tau + max(-div v, 0) (2 - alpha), tau = h/(decay c_s)   (Monaghan
/// 2005, 8.27 and 8.28, Morris & Monaghan 1997): as many steps late as the source needs to act.
struct MorrisMonaghan {
    double alpha_0 = 0.1, decay = 0.2;
    static constexpr auto knobs() {
        return std::tuple{Knob{"alpha-0", &MorrisMonaghan::alpha_0, {0, 10}, "strength far from a shock"},
                          Knob{"decay", &MorrisMonaghan::decay, {0, 10, true}, "speed of its decay [c_s/h]"}};
    }
    using Columns = List<VelocityGradient, ViscosityAlpha>;
    using Slopes = List<VelocityGradient>;
    void start(auto& p) const { p.alpha.assign(p.size(), alpha_0); }
    template <class P>
    void evolve(P& p, double dt) const {
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto row = load<P::d>(p, i, List<VelocityGradient>{});
            const double source = std::max(-divergence(row.dv_dx), 0.0), tau = p.h[i] / (decay * p.c_s[i]);
            const double rate = 1 / tau + source;  // alpha relaxes to (alpha_0/tau + 2 source)/rate
            const double target = (alpha_0 / tau + 2 * source) / rate;
            p.alpha[i] = target + (p.alpha[i] - target) * std::exp(-rate * dt);
        }
    }
};

/// Morris & Monaghan's alpha, and d alpha_u/dt = -alpha_u/tau + |grad sqrt u|   (Price 2004, PhD thesis,
/// Cambridge; Monaghan 2005, after 8.28).
struct PriceSwitch {
    MorrisMonaghan viscosity{};
    static auto parts(auto& self) { return std::tie(self.viscosity); }
    using Columns = List<VelocityGradient, ViscosityAlpha, EnergyGradient, ConductionAlpha>;
    using Slopes = List<VelocityGradient, EnergyGradient>;
    void start(auto& p) const { viscosity.start(p); }
    template <class P>
    void evolve(P& p, double dt) const {
        viscosity.evolve(p, dt);
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto row = load<P::d>(p, i, List<EnergyGradient>{});
            const double tau = p.h[i] / (viscosity.decay * p.c_s[i]);
            const double source = std::sqrt(dot(row.du_dx, row.du_dx) / p.u[i]) / 2;
            const double target = tau * source;
            p.alpha_u[i] = std::min(target + (p.alpha_u[i] - target) * std::exp(-dt / tau), 1.0);
        }
    }
};

/// A factor of each particle's viscosity that is small where the flow shears.
struct ShearFactor {
    static constexpr std::string_view name = "factor of the viscosity";
    template <class T, int>
    struct In {
        T factor{};
    };
    static auto of(const auto& a) { return a.factor; }
};

/// |div v|/(|div v| + |curl v|)   (8.24, Balsara 1995), in 2D.
struct Balsara {
    using Columns = List<VelocityGradient, ShearFactor>;
    using Slopes = List<VelocityGradient>;
    template <class P>
    void measure(P& p) const {
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto row = load<2>(p, i, List<VelocityGradient>{});
            const double div = std::abs(divergence(row.dv_dx));
            const double curl = std::abs(row.dv_dx[1][0] - row.dv_dx[0][1]);
            p.factor[i] = div > 0 ? div / (div + curl) : 0;
        }
    }
};

/// |div v|/(|div v| + sqrt(E^ij E^ij) + 1e-4 c_s/h), E = (grad v + grad v^T)/2   (8.25, 8.26, Colagrossi
/// 2004).
struct Colagrossi {
    using Columns = List<VelocityGradient, ShearFactor>;
    using Slopes = List<VelocityGradient>;
    template <class P>
    void measure(P& p) const {
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto row = load<2>(p, i, List<VelocityGradient>{});
            const auto& g = row.dv_dx;
            const double div = std::abs(divergence(g)), off = 0.5 * (g[0][1] + g[1][0]);
            const double E = std::sqrt(g[0][0] * g[0][0] + g[1][1] * g[1][1] + 2 * off * off);
            p.factor[i] = div / (div + E + 1e-4 * p.c_s[i] / p.h[i]);
        }
    }
};

}  // namespace sph
