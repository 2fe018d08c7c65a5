#pragma once
#include <complex>
#include <vector>

namespace exact {

/// The linear instability of two streams of gas that slide along each other (Kelvin and Helmholtz), in a
/// periodic square of side 1. With f = tanh(sin(2 pi y)/(2 pi w)), which is 1 in 0 < y < 1/2, -1 in 1/2 < y <
/// 1, and w the width of the layers between,
///     v_x = V f,   rho = (rho_1 + rho_2)/2 + f (rho_1 - rho_2)/2,   p = P,
/// and small disturbances like exp(i (k x - omega t)), k = 2 pi, for which the Euler equations give
///     (omega - k v_x) v_x' = v_x,y (v_y'/i) + k p'/rho,   (omega - k v_x) (v_y'/i) = - p',y/rho,
///     (omega - k v_x) p' = gamma P (k v_x' + (v_y'/i),y).
/// Solved on `points` equidistant y with Fourier derivatives: 64 leave an error of 1e-4 of the growth at
/// w = 0.05. Check: w = 0.02, rho_1 = rho_2, V far below the speed of sound: Michalke, J. Fluid Mech. 19
/// (1964) 543, for a single layer tanh(y/w).
class ShearInstability {
  public:
    struct Flow {
        double gamma = 5.0 / 3;
        double speed = 0.5;     ///< V > 0
        double inner = 2;       ///< rho_1 > 0
        double outer = 1;       ///< rho_2 > 0
        double pressure = 2.5;  ///< P > 0
        double width = 0.05;    ///< w, 0.01..0.2
    };
    /// points: even, 16..256. Throws std::domain_error, which names the value, outside these ranges.
    /// Cost: the eigenvalues of a matrix of 3 points; with 64 a quarter of a second.
    explicit ShearInstability(const Flow& flow, int points = 64);

    /// Of the fastest disturbance, exp(growth t) [1/time]; 0 where none grows.
    double growth() const { return omega_.imag(); }
    std::complex<double> omega() const { return omega_; }

    struct State {
        double rho, v_x, v_y, p;
    };
    /// The flow without a disturbance.
    State base(double y) const;
    /// What the fastest one adds at t = 0; its largest |v_y| is 1.
    State disturbance(double x, double y) const;
    /// v_y of the fastest one at x = 0 as a complex number, to project on.
    std::complex<double> mode(double y) const;

  private:
    using Coefficients = std::vector<std::complex<double>>;
    std::complex<double> sum(const Coefficients& of, double y) const;
    double profile(double y) const;

    Flow flow_;
    std::complex<double> omega_;
    Coefficients u_, w_, p_;  // of v_x', v_y'/i and p', by wave number from -points/2 on
};

}  // namespace exact
