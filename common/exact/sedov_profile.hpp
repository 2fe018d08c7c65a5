#pragma once

namespace exact {

/// What a point blast looks like at all times: the similarity solution of Sedov, von Neumann and Taylor for a
/// uniform cold gas, in lambda = r/R(t) and in units of the state behind the shock at lambda = 1. In
/// dimension d it is known in closed form as a function of a parameter y that runs from 0 at the centre to 1
/// at the shock, with z = 1 - y and
///     x1 = 1 - z (gamma-1)/(2 gamma),   x3 = 1 + z (gamma-1) N/(gamma D),   x4 = 1 + z/gamma,
///     M = 2 (gamma-1) + d,   N = 2 + d (gamma-1),   D = 3d - 2 - (d-2) gamma:
///     lambda = x1^(-2/(d+2)) y^a2 x3^(-a1),   v = x1 lambda,   u = v^2 x4/y,   p = rho u,
///     rho = y^(d/M) x3^a4 x4^(-2/(2-gamma)),
///     a1 = (d+2) gamma/N [2d (2-gamma)/(gamma (d+2)^2) + (gamma-1)/M],   a2 = (gamma-1)/M,
///     a4 = (d+2) a1/(2-gamma).
/// Source: Kamm, Evaluation of the Sedov-von Neumann-Taylor blast wave solution, LA-UR-00-6055 (2000), eqs
/// 29-47 with omega = 0 and y = x2 (Sedov, Similarity and Dimensional Methods (1959), chapter IV, section
/// 11). Here x1, x3, x4 are rewritten so that nothing cancels near the shock, and u by the energy integral.
///
/// The last two powers of rho go to 1^infinity for gamma -> 2. They are computed as
///     x3^(a4 - 2/(2-gamma)) (x4/x3)^(-2/(2-gamma)),   a4 - 2/(2-gamma) = (d-2) D/(M N),
///     x4/x3 = 1 + (2-gamma) q,   q = z d (gamma+1)/(gamma D x3),
/// in which gamma = 2 is nothing special: the second one becomes exp(-2q).
///
/// For D -> 0, gamma -> 7 in three dimensions, the profile goes to rho = v = lambda, p = lambda^3,
/// and for gamma > 7 a vacuum opens at the centre.
class SedovProfile {
  public:
    static constexpr double least_gamma = 1.001;  ///< below, rounding of lambda moves rho by 1e-12
    static constexpr double largest_gamma = 100;  ///< excluded in three dimensions: 7
    static constexpr double vacuum_gamma = 7;

    /// dimension d = 1, 2 or 3; gamma in least_gamma..largest_gamma, and below vacuum_gamma for d = 3.
    /// Throws std::domain_error, which names the value, outside these ranges.
    SedovProfile(int dimension, double gamma);

    struct Ratio {
        double rho, v, p, u;
    };
    /// The state at lambda in 0..1, over that behind the shock. At lambda = 0: rho = v = 0, the p of the
    /// centre, and u is infinite, as it is wherever it exceeds the largest double: it grows with
    /// lambda^(-d/(gamma-1)). Throws std::domain_error for other lambda.
    Ratio at(double lambda) const;

    /// Integral of (rho v^2 + p) lambda^(d-1) from lambda = 0 to 1. Behind a strong shock the kinetic and the
    /// thermal energy are equal, so that both terms have the same unit. Relative error 1e-15.
    double energy_integral() const;

  private:
    // Functions of log_y = ln y, with which the centre is as well resolved as the shock.
    double log_lambda(double log_y) const;
    double slope(double log_y) const;  ///< d log_lambda / d log_y
    double log_y_at(double log_lambda) const;
    Ratio ratio(double log_y) const;

    int dimension_;
    double gamma_;
    double k1_, k3_;              ///< x1 = 1 - k1 z, x3 = 1 + k3 z
    double a0_, a1_, a2_;         ///< exponents of lambda
    double rho_y_, rho_x3_, q0_;  ///< d/M, (d-2) D/(M N), q = q0 z/x3
};

}  // namespace exact
