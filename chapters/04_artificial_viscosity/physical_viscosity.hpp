#pragma once
#include <limits>

#include "chapters/04_artificial_viscosity/dissipation.hpp"
#include "chapters/04_artificial_viscosity/slopes.hpp"

/// Real viscosity, in two forms. The parameter of both is the KINEMATIC viscosity nu = mu/rho
/// [length^2/time], the same everywhere; the dynamic one is then mu = rho nu. Where fluids differ, each
/// particle has a DYNAMIC viscosity mu of its own. Both forms act on particles that approach each other and
/// on those that recede, conserve momentum, and heat by what they take from the motion.
namespace sph {

template <class T>
constexpr Knob<T> nu_knob(double T::*nu) {
    return {"nu", nu, {0, 1e6}, "kinematic viscosity [length^2/time]"};
}

/// factor nu/min(h_i, h_j)^2: the rate [1/time] at which viscosity evens out velocities between neighbours.
/// The step is courant over the largest of these and of SignalRate. Tested: with courant = 0.3 the factors
/// below hold, twice that is too much for the pairwise form.
Tile viscous_rate(double factor, const auto& nu, const auto& i, const auto& j, const auto& pair) {
    const Tile h = j.h.min(i.h);
    return (mean_F(pair) < 0).select(factor * nu / (h * h), 0.0);
}

/// Pi_ij = -coefficient eta_ij v_ij . x_ij/(r^2 + epsilon h^2), eta_ij = mu_i mu_j/(rho_i rho_j (mu_i +
/// mu_j))   (Monaghan 2005, 8.9; Cleary 1998), for an eta [length^5/(mass time) in 3D] that is known.
Tile pair_friction(const auto& viscosity, const Tile& eta, const auto& i, const auto& j, const auto& pair) {
    const Tile h = 0.5 * (i.h + j.h);
    const Tile stretch = dot(i.v_mid - j.v_mid, pair.x_ij) / (pair.r * pair.r + viscosity.epsilon * h * h);
    return -viscosity.coefficient * eta * stretch;
}
/// The force of a pair, and how it limits the step.
void add_friction(const auto& viscosity, const auto& i, const auto& j, const auto& pair, auto& sum) {
    sum.dv_dt -= j.m * viscosity.pressure(i, j, pair) * mean_F(pair) * pair.x_ij;
    sum.step_rate = sum.step_rate.max(viscosity.rate(i, j, pair));
}

/// (8.9) with mu = rho nu, so that eta_ij = nu/(rho_i + rho_j). Central forces: angular momentum is conserved
/// too.
/// In d dimensions an integral over the neighbourhood gives, with coefficient = 4 (d + 2), the shear
/// viscosity mu and the bulk viscosity 5/3 mu (after 8.7): 16 in 2D, as printed, 20 in 3D. A sum over few
/// neighbours gives less: on a square lattice with the cubic spline and h = 1.2 spacings shear would
/// need 20.1, near the 19.8 that Cleary found, and compression 15.2; with Wendland C4 and h = 2.6
/// spacings, 16.4 and 16.0. So 16, and more neighbours. epsilon > 0 keeps a particle and itself from 0/0; the
/// 0.01 of the review costs 2 % of the viscosity, 1e-4 nothing that can be measured. nu >= 0 [length^2/time].
struct PairwiseViscosity {
    double nu = 0, coefficient = 16, epsilon = 1e-4;
    static constexpr auto knobs() { return std::tuple{nu_knob(&PairwiseViscosity::nu)}; }
    using Reads = List<MiddleVelocity, Density, SmoothingLength>;
    Tile pressure(const auto& i, const auto& j, const auto& pair) const {
        return pair_friction(*this, nu / (i.rho + j.rho), i, j, pair);
    }
    Tile rate(const auto& i, const auto& j, const auto& pair) const {
        return viscous_rate(8, nu, i, j, pair);
    }
};
template <>
struct ViscousForce<PairwiseViscosity> {
    PairwiseViscosity viscosity;
    using Reads = PairwiseViscosity::Reads;
    using ReadsJ = List<Mass>;
    using Adds = List<Acceleration, StepRate>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        add_friction(viscosity, i, j, pair, sum);
    }
};

/// A particle's own DYNAMIC viscosity, mu >= 0 [mass/(length time) in 3D, mass/time in 2D].
struct DynamicViscosity {
    static constexpr std::string_view name = "dynamic viscosity";
    template <class T, int>
    struct In {
        T mu{};
    };
};
/// No detector: the scene says once what the viscosity of each particle is.
struct GivenViscosity {
    using Columns = List<DynamicViscosity>;
    using Slopes = List<>;
};
/// The mean of two dynamic viscosities. Harmonic, 2 mu_i mu_j/(mu_i + mu_j): that of equal layers in series,
/// which (8.9) has; stress is continuous where mu jumps, and a fluid without viscosity holds no other back.
/// Arithmetic, (mu_i + mu_j)/2: that of layers side by side (Morris, Fox & Zhu 1997, J. Comput. Phys. 136,
/// 214, add both so); for the question what is wrong with it.
enum class MeanViscosity { harmonic, arithmetic };

/// (8.9) between fluids whose mu differs: eta_ij = mean of mu_i and mu_j/(2 rho_i rho_j). Which mean is asked
/// once in eight pairs, so that both are one pass.
struct LayeredViscosity {
    MeanViscosity mean = MeanViscosity::harmonic;
    double coefficient = 16, epsilon = 1e-4;  ///< as in PairwiseViscosity
    using Reads = List<MiddleVelocity, Density, SmoothingLength, DynamicViscosity>;
    Tile pressure(const auto& i, const auto& j, const auto& pair) const {
        const Tile sum = i.mu + j.mu;
        const Tile half_mean = mean == MeanViscosity::harmonic
                                   ? i.mu * j.mu / sum.max(std::numeric_limits<double>::min())
                                   : sum / 4;
        return pair_friction(*this, half_mean / (i.rho * j.rho), i, j, pair);
    }
    Tile rate(const auto& i, const auto& j, const auto& pair) const {
        return viscous_rate(8, (j.mu / j.rho).max(i.mu / i.rho), i, j, pair);
    }
};
template <>
struct ViscousForce<LayeredViscosity> {
    LayeredViscosity viscosity;
    using Reads = LayeredViscosity::Reads;
    using ReadsJ = List<Mass>;
    using Adds = List<Acceleration, StepRate>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        add_friction(viscosity, i, j, pair, sum);
    }
};

/// The viscous stress of the Navier-Stokes equations   [pressure].
struct ViscousStress {
    static constexpr std::string_view name = "viscous stress";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> tau{};
    };
};
/// tau_ab = rho nu (d_a v_b + d_b v_a - 2/3 delta_ab div v)   (Monaghan 2005, 8.1 without bulk viscosity;
/// Chen 2017, 47), from gradients that are exact where v is linear. The 2/3 belongs to three dimensions, of
/// which a plane flow uses two. nu >= 0 [length^2/time].
struct StressDetector {
    double nu = 0;
    static constexpr auto knobs() { return std::tuple{nu_knob(&StressDetector::nu)}; }
    using Columns = List<VelocityGradient, ViscousStress>;
    using Slopes = List<VelocityGradient>;
    template <class P>
    void measure(P& p) const {
        constexpr int d = P::d;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto g = load<d>(p, i, List<VelocityGradient>{}).dv_dx;
            const double mu = p.rho[i] * nu, spread = 2.0 / 3 * divergence(g);
            for (std::size_t a = 0; a < d; ++a) {
                for (std::size_t b = 0; b < d; ++b)
                    p.tau[a][b][i] = mu * (g[a][b] + g[b][a] - (a == b ? spread : 0));
            }
        }
    }
};

/// The force and the heat of a stress that StressDetector has left; nu only for the step.
struct StressViscosity {
    double nu = 0;
    static constexpr auto knobs() { return std::tuple{nu_knob(&StressViscosity::nu)}; }
};
/// tau . x
template <class T, int d>
Vec<Tile, d> apply(const Vec<Vec<T, d>, d>& tau, const Vec<Tile, d>& x) {
    Vec<Tile, d> result;
    for (std::size_t a = 0; a < x.size(); ++a) result[a] = dot(tau[a], x);
    return result;
}

/// dv_i/dt = sum_j m_j (tau_i/rho_i^2 . grad_i W_ij(h_i) + tau_j/rho_j^2 . grad_i W_ij(h_j)): what sigma = -P
/// + tau adds to the pressure force   (Chen 2017, 49, where a minus sign is printed that fits -sigma).
/// Antisymmetric in i and j, so that momentum is conserved; not along x_ij, so that angular momentum is not.
template <>
struct ViscousForce<StressViscosity> {
    StressViscosity viscosity;
    using Reads = List<Density, ViscousStress, SmoothingLength>;
    using ReadsJ = List<Mass>;
    using Adds = List<Acceleration, StepRate>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const Tile from_i = j.m * F_i(pair) / (i.rho * i.rho);
        const Tile from_j = j.m * F_j(pair) / (j.rho * j.rho);
        sum.dv_dt += from_i * apply(i.tau, pair.x_ij);
        sum.dv_dt += from_j * apply(j.tau, pair.x_ij);
        sum.step_rate = sum.step_rate.max(viscous_rate(2, viscosity.nu, i, j, pair));
    }
};

/// du_i/dt = - tau_i/rho_i^2 : sum_j m_j v_ij grad_i W_ij(h_i): the work of the terms with tau_i, as pressure
/// heats (5.13). It is the tau : grad v/rho of (Chen 2017, 50), mu/(2 rho) epsilon : epsilon, with the
/// gradient that the force works on, so that no energy is lost: with any other, as printed there, the sums do
/// not match.
template <>
struct ViscousHeating<StressViscosity> {
    StressViscosity viscosity;
    using Reads = List<Velocity>;
    using ReadsI = List<Density, ViscousStress>;
    using ReadsJ = List<Mass>;
    using Adds = List<Heating>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const Tile weight = j.m * F_i(pair) / (i.rho * i.rho);
        sum.du_dt -= weight * dot(i.v - j.v, apply(i.tau, pair.x_ij));
    }
};

}  // namespace sph
