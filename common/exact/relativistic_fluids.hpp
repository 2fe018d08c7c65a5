#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "common/exact/finite_volume.hpp"
#include "common/exact/lorentz.hpp"

namespace exact {

/// What the relativistic finite-volume scheme needs of a fluid. All is free of branches, so that loops over
/// it are vectorised. c = 1; z = W v is the four-velocity, W the Lorentz factor.
namespace relativistic {

/// From z, without loss as v -> 1: W = sqrt(1 + z^2), 1/W and v = z/W.
struct Motion {
    double lorentz, slow, v;
    explicit Motion(double z) : lorentz{std::sqrt(1 + z * z)}, slow{1 / lorentz}, v{z * slow} {}
};

/// The equations of motion for primitive values, with the rapidity y, dy = dz/W, the enthalpy w = e + p per
/// volume at rest, and the speed of sound c_s:
///     dy/dt = -[v (1 - c_s^2) y_x + p_x/(w W^2)]/(1 - v^2 c_s^2),    theta = v dy/dt + y_x,
///     de/dt = -v e_x - w theta,   drho/dt = -v rho_x - rho theta,   dp/dt = -v p_x - w c_s^2 theta.
/// From d_mu T^mu_nu = 0; W theta is the divergence d_mu u^mu. Here dz/dt and theta times the width of a
/// cell, from the differences dz and dp_w = dp/w across it; c2 = c_s^2.
struct Rates {
    double dz_dt, theta;
    Rates(const Motion& m, double dz, double dp_w, double c2) {
        const double dy = dz * m.slow;
        const double dy_dt = -(m.v * (1 - c2) * dy + dp_w * m.slow * m.slow) / (1 - m.v * m.v * c2);
        dz_dt = dy_dt * m.lorentz;
        theta = m.v * dy_dt + dy;
    }
};

}  // namespace relativistic

/// An ideal gas with a conserved rest mass, p = (gamma-1) rho u, enthalpy w = rho + gamma/(gamma-1) p.
struct RelativisticGas {
    double gamma = 5.0 / 3;  ///< (1, 2]

    static constexpr std::size_t unknowns = 3;
    using Cells = GasCells;
    using State = Riemann::State;                 ///< rho > 0, |v| < 1, p > 0
    using Values = std::array<double, unknowns>;  ///< primitive: z, p, rho; conserved: S, tau, D
    using Columns = std::array<const double*, unknowns>;
    using Results = std::array<double*, unknowns>;

    void check() const;                     ///< throws std::domain_error for gamma outside its range
    static void check(const State& state);  ///< and for a state outside of them
    static Values primitive(const State& s) { return {relativistic::four_velocity(s.v), s.p, s.rho}; }
    static State state(const Values& q) { return {q[2], relativistic::Motion{q[0]}.v, q[1]}; }

    double enthalpy(const Values& q) const { return q[2] + gamma / (gamma - 1) * q[1]; }
    double pressure(const Values& q) const { return q[1]; }
    double sound_speed_squared(const Values& q) const { return gamma * q[1] / enthalpy(q); }
    /// S = w W^2 v,   tau = w W^2 - p - D,   D = rho W;   m: of the z in q.
    Values conserved(const Values& q, const relativistic::Motion& m) const {
        const auto [z, p, rho] = q;
        const double mass = rho * m.lorentz, heat = gamma / (gamma - 1) * p;
        return {(rho + heat) * m.lorentz * z, mass * z * z / (1 + m.lorentz) + heat * z * z + p / (gamma - 1),
                mass};
    }
    /// d(primitive)/dt times a cell's width as seen by an observer of velocity `face`, from the differences
    /// across the cell: relativistic::Rates.
    Values rates(const Values& q, const Values& dq, double face) const {
        const auto [z, p, rho] = q;
        const relativistic::Motion m{z};
        const double per_w = 1 / enthalpy(q);
        const relativistic::Rates r{m, dq[0], dq[1] * per_w, gamma * p * per_w};
        return {r.dz_dt + face * dq[0], (face - m.v) * dq[1] - gamma * p * r.theta,
                (face - m.v) * dq[2] - rho * r.theta};
    }
    /// The primitive values of `n` cells with the conserved values u. p = -1 says that there are none: D <= 0
    /// or tau + D below sqrt(S^2 + D^2) by more than rounding. With e = tau/D and r = |S|/D, z is the root of
    ///     z h(z) = r,    h = 1 + gamma u(z),   u(z) = W e - z r + z^2/(1 + W),
    /// by Newton's method, for many cells at once. It starts at the z of gas without pressure that has this S
    /// and tau + D, and ends when a step changes z by less than 1e-9: the next would be below rounding. A
    /// bracket guarantees that it ends; for 1e6 random states Newton's method did as well without.
    /// Source: Galeazzi et al., Phys. Rev. D 88 (2013) 064009 (z and u).
    ///
    /// Errors, measured for p/rho 1e-10..1e6, W to 1000, gamma 1.01..2, in units of 2^-52 W^2/(1 - v^2
    /// c_s^2), which is what the rounding of S, tau and D makes of it: 6 for z and rho, relative, and 5 for p
    /// in units of w - rho + min(1, z^2) rho. Where that is more than p, all that is left of p is that it is
    /// positive. Cost: 5 to 13 nanoseconds a cell with AVX-512; nearly all need 1 to 5 steps.
    void recover(std::size_t n, const Columns& u, const Results& q) const;
};

/// Cells side by side, as GasCells, of a fluid without rest mass.
struct FluidCells {
    struct State {
        double eps, v;  ///< energy density at rest > 0, |v| < 1
    };
    std::vector<double> faces;  ///< increasing [L], one more than there are cells
    std::vector<State> states;

    std::size_t size() const noexcept { return states.size(); }
    double centre(std::size_t i) const { return (faces[i] + faces[i + 1]) / 2; }
    double width(std::size_t i) const { return faces[i + 1] - faces[i]; }
};

/// A fluid without rest mass or baryons, p = c2 eps: two unknowns, T01 and T00. The primitive value is the
/// root eps^(1/4), for c2 = 1/3 the temperature: beside a vacuum it is straighter than eps, and slopes of it
/// halve the error of a slab.
struct BaryonFreeFluid {
    double c2 = 1.0 / 3;  ///< speed of sound squared, (0, 1)

    static constexpr std::size_t unknowns = 2;
    using Cells = FluidCells;
    using State = FluidCells::State;
    using Values = std::array<double, unknowns>;  ///< primitive: z, eps^(1/4); conserved: T01, T00
    using Columns = std::array<const double*, unknowns>;
    using Results = std::array<double*, unknowns>;

    void check() const;                     ///< throws std::domain_error for c2 outside its range
    static void check(const State& state);  ///< and for a state outside of them
    static Values primitive(const State& s) {
        return {relativistic::four_velocity(s.v), std::sqrt(std::sqrt(s.eps))};
    }
    static State state(const Values& q) { return {fourth_power(q[1]), relativistic::Motion{q[0]}.v}; }
    static double fourth_power(double root) { return (root * root) * (root * root); }
    /// The entropy density in the frame of the grid, s* = W eps^(1/(1+c2)): 1 at rest at eps = 1.
    double entropy_star(const State& s) const {
        return std::pow(s.eps, 1 / (1 + c2)) * relativistic::Motion{relativistic::four_velocity(s.v)}.lorentz;
    }

    double pressure(const Values& q) const { return c2 * fourth_power(q[1]); }
    double sound_speed_squared(const Values&) const { return c2; }
    /// T01 = w W^2 v,   T00 = w W^2 - p,   w = (1 + c2) eps.
    Values conserved(const Values& q, const relativistic::Motion& m) const {
        const double eps = fourth_power(q[1]), w = (1 + c2) * eps, z = q[0];
        return {w * z * m.lorentz, w * z * z + eps};
    }
    Values rates(const Values& q, const Values& dq, double face) const {
        const relativistic::Motion m{q[0]};
        const relativistic::Rates r{m, dq[0], 4 * c2 / (1 + c2) * dq[1] / q[1], c2};
        return {r.dz_dt + face * dq[0], (face - m.v) * dq[1] - (1 + c2) / 4 * q[1] * r.theta};
    }
    /// As that of RelativisticGas, in closed form: T01^2 = (T00 + c2 eps)(T00 - eps), so with b = (1-c2) T00
    ///     eps = 2 (T00^2 - T01^2)/[b + sqrt(b^2 + 4 c2 (T00^2 - T01^2))].
    /// eps^(1/4) = -1 says that there is none: T00 <= |T01|. Cost: 3 nanoseconds a cell.
    void recover(std::size_t n, const Columns& u, const Results& q) const;
};

}  // namespace exact
