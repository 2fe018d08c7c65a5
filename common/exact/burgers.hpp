#pragma once
#include <array>

namespace exact {

/// The viscous Burgers equation with the initial values of a sine wave, which steepens into a standing shock
/// at x = 1 (and at every odd integer) and then decays:
///     u_t + u u_x = nu u_xx,    u(x, 0) = sin(pi x),    hence u odd in x, of period 2, and 0 at integers.
/// With the Cole-Hopf substitution u = -2 nu phi_x / phi it is the heat equation for phi, so that
///     u(x, t) = Int sin(pi y) w(y) dy / Int w(y) dy,
///     w(y)    = exp[-(x - y)^2 / (4 nu t) - (1 - cos(pi y)) / (2 pi nu)].
/// Source: Hopf, Comm. Pure Appl. Math. 3 (1950) 201; Cole, Quart. Appl. Math. 9 (1951) 225. The problem is
/// that of Ye et al. (2019), doi:10.1088/0253-6102/71/11/1281, among many.
///
/// All is dimensionless: lengths in half periods of the initial wave, speeds in its amplitude.
/// Accuracy: 1e-12 absolute and relative in the whole range, also at the zeros of u and where u is tiny, down
/// to 2e-308; below, it loses its digits and becomes 0. Measured at 19,850 random and hard places: 1.8e-15
/// absolute; relative 3.5e-14 for nu >= 1e-3 and 1.9e-13 below. x is taken as exact: in the shock, a slope up
/// to 1 / (2 nu) multiplies the rounding of an x like 0.9.
class Burgers {
  public:
    static constexpr double least_viscosity = 1e-4;
    static constexpr double largest_viscosity = 100;
    static constexpr double largest_time = 100;

    /// `viscosity`: kinematic, nu [-], least_viscosity..largest_viscosity.
    /// Throws std::domain_error, which names the value, outside this range.
    explicit Burgers(double viscosity);

    double viscosity() const noexcept { return viscosity_; }

    /// u(x, t) [-] at any finite x [-], at time t [-] in 0..largest_time.
    /// Throws std::domain_error, which names the value, outside this range.
    /// Cost, up to nu t = 0.1: the sine or cosine in the exponent of 30 to 120 nodes, twice, and two
    /// exponentials and one sine for 30 to 75 of them (360 and 90 at viscosity 1e-4); then six exponentials
    /// and 12 sines and cosines. That is 0.3 to 3 microseconds.
    double velocity(double x, double t) const;

  private:
    struct Folded;
    static constexpr int terms = 6;

    double by_quadrature(const Folded& point, double t) const;
    double by_series(const Folded& point, double t) const;

    double viscosity_;
    double steepness_;                        ///< 1 / (2 pi nu), the Reynolds number of the initial wave
    std::array<double, terms> bessel_ratio_;  ///< I_n / I_0 at the steepness, n = 1..terms
};

}  // namespace exact
