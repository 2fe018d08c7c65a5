#pragma once
#include "common/exact/hllc.hpp"

/// What the two frames of FiniteVolume make of the same three columns. All are free of branches.
namespace exact::frames {

/// Three values of one cell or face, in the order of the columns.
struct Three {
    double a, b, c;
};

/// gas (rho, v, p), conserved (rho, rho v, E), coordinate x.
struct Eulerian {
    static constexpr bool faces_move = false;
    double gamma;

    /// d/dt of the gas times the cell's width, from the differences across the cell:
    ///     rho' = -v rho_x - rho v_x,   v' = -v v_x - p_x/rho,   p' = -v p_x - gamma p v_x.
    /// Source: Toro (2009), eq. 3.4.
    Three rates(const Three& q, const Three& dq) const {
        return {-q.b * dq.a - q.a * dq.b, -q.b * dq.b - dq.c / q.a, -q.b * dq.c - gamma * q.c * dq.b};
    }
    hllc::Gas state(double rho, double v, double p) const { return {rho, v, p}; }
    double face_velocity(const hllc::Fan&) const { return 0; }
    Three flux(const hllc::Gas& l, const hllc::Gas& r, const hllc::Fan& waves) const {
        const auto [mass, momentum, energy] = hllc::flux(l, r, waves, gamma);
        return {mass, momentum, energy};
    }
    Three gas(const Three& u) const {
        const double v = u.b / u.a;
        return {u.a, v, (gamma - 1) * (u.c - u.b * v / 2)};
    }
    Three conserved(const hllc::Gas& s) const {
        return {s.rho, s.rho * s.v, s.p / (gamma - 1) + s.rho * s.v * s.v / 2};
    }
    double width(double dx, double) const { return dx; }  ///< in the coordinate
    double dx(double width, double) const {
        return width;
    }  ///< of a cell of this width, from its first column
};

/// gas (1/rho, v, p), conserved (1/rho, v, e), coordinate m.
struct Lagrangian {
    static constexpr bool faces_move = true;
    double gamma;

    /// The same per mass:  (1/rho)' = v_m,   v' = -p_m,   p' = -gamma p rho v_m.
    Three rates(const Three& q, const Three& dq) const { return {dq.b, -dq.c, -gamma * q.c / q.a * dq.b}; }
    hllc::Gas state(double volume, double v, double p) const { return {1 / volume, v, p}; }
    double face_velocity(const hllc::Fan& waves) const { return waves.contact; }
    Three flux(const hllc::Gas&, const hllc::Gas&, const hllc::Fan& waves) const {
        return {-waves.contact, waves.pressure, waves.pressure * waves.contact};
    }
    Three gas(const Three& u) const { return {u.a, u.b, (gamma - 1) * (u.c - u.b * u.b / 2) / u.a}; }
    Three conserved(const hllc::Gas& s) const {
        return {1 / s.rho, s.v, s.p / ((gamma - 1) * s.rho) + s.v * s.v / 2};
    }
    double width(double dx, double rho) const { return rho * dx; }
    double dx(double width, double volume) const { return width * volume; }
};

}  // namespace exact::frames
