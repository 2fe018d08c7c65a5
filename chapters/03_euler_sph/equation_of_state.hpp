#pragma once
#include <cmath>

/// Equations of state, as small types. A barotropic one has, for rho > 0,
///     pressure(rho), sound_speed(rho), energy(rho) = integral of P/rho^2 d rho,
/// the energy being what compression without dissipation has stored, by mass (Monaghan 2005, 5.5).
namespace sph {

/// P = K rho^gamma, K > 0 constant entropy, gamma > 1.
struct Polytrope {
    double K, gamma;
    double pressure(double rho) const { return K * std::pow(rho, gamma); }
    double sound_speed(double rho) const { return std::sqrt(gamma * K * std::pow(rho, gamma - 1)); }
    double energy(double rho) const { return K / (gamma - 1) * std::pow(rho, gamma - 1); }
};

/// The same for gamma = 2, the gas of Monaghan & Price's toy stars and of shallow water: no powers needed.
struct Quadratic {
    double K;
    double pressure(double rho) const { return K * rho * rho; }
    double sound_speed(double rho) const { return std::sqrt(2 * K * rho); }
    double energy(double rho) const { return K * rho; }
};

/// P = c_s^2 rho; the energy counts from rho = 1.
struct Isothermal {
    double c_s;
    double pressure(double rho) const { return c_s * c_s * rho; }
    double sound_speed(double) const { return c_s; }
    double energy(double rho) const { return c_s * c_s * std::log(rho); }
};

/// A liquid: P = B [(rho/rho_0)^gamma - 1], B = rho_0 c_0^2/gamma, with c_0 ten times the flow's speed to
/// keep changes of density near 1 % (Cole 1948; Monaghan 2005, section 10, with gamma = 7). P < 0 for
/// rho < rho_0. The energy counts from rho = rho_0.
struct Cole {
    double rho_0, c_0, gamma = 7;
    double pressure(double rho) const {
        return rho_0 * c_0 * c_0 / gamma * (std::pow(rho / rho_0, gamma) - 1);
    }
    double sound_speed(double rho) const { return c_0 * std::pow(rho / rho_0, (gamma - 1) / 2); }
    double energy(double rho) const {
        const double r = rho / rho_0;
        return c_0 * c_0 / gamma * ((std::pow(r, gamma - 1) - 1) / (gamma - 1) + 1 / r - 1);
    }
};

/// P = (gamma - 1) rho u: with u [energy by mass] evolved, not a function of rho; gamma > 1.
struct IdealGas {
    double gamma;
    double pressure(double rho, double u) const { return (gamma - 1) * rho * u; }
    double sound_speed(double u) const { return std::sqrt(gamma * (gamma - 1) * u); }
};

}  // namespace sph
