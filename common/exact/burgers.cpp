#include "common/exact/burgers.hpp"

#include <gsl/gsl_sf_bessel.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/exact/require.hpp"

namespace exact {
namespace {

using std::numbers::pi;

/// What is smaller than exp(-negligible) = 8e-20 of the whole is left out, of sums as of error bounds.
constexpr double negligible = 44;

/// From this nu t on the series takes the quadrature's place. Its terms then fall like exp(-0.99 n^2): none
/// cancels another by more than a digit, also at x = 1, and the seventh is below 1e-19 of the first, which
/// keeps its digits however small it is. The quadrature would lose them, as crests cancel troughs under a
/// wide weight.
constexpr double series_from = 0.1;

constexpr const char* problem = "Burgers' equation";

double square(double a) {
    return a * a;
}

/// Step of the trapezoidal rule, for an error below exp(-negligible) of the integral of the weight w(y).
/// The rule's error for an analytic integrand is at most 2 exp(-2 pi b / h) times the integral of |w| along
/// the line Im y = b (Trefethen and Weideman, SIAM Review 56 (2014) 385, theorem 5.1), and here
///     |w(y + i b)| <= w(y) exp(g),   g(b) = b^2 / spread + steepness (cosh(pi b) - 1).
/// Each term alone reaches T = negligible at b_1 = sqrt(spread T) and b_2 = acosh(1 + T / steepness) / pi.
/// Both grow at least like b^2, so g <= T at 1/b^2 = 1/b_1^2 + 1/b_2^2, and h = pi b / T makes the bound
/// exp(-2T + g).
double trapezoidal_step(double spread, double steepness) {
    const double b_1 = std::sqrt(spread * negligible);
    const double b_2 = std::acosh(1 + negligible / steepness) / pi;
    return pi / (negligible * std::hypot(1 / b_1, 1 / b_2));
}

}  // namespace

/// x = centre + sign * distance up to whole periods, where centre is 0 or 1, whichever zero of u is nearer:
/// u(x) = sign * u(centre + distance) for centre 0, and sign * u(centre - distance) for centre 1.
/// Both steps are exact, so that u keeps all digits that x has left beside a zero.
struct Burgers::Folded {
    double distance;  ///< 0..1/2
    bool at_shock;    ///< centre 1, where the characteristics meet
    double sign;

    explicit Folded(double x) {
        const double reduced = std::remainder(x, 2.0);
        const double magnitude = std::fabs(reduced);
        at_shock = magnitude > 0.5;
        distance = at_shock ? 1 - magnitude : magnitude;
        sign = reduced < 0 ? -1 : 1;
    }
};

Burgers::Burgers(double viscosity) : viscosity_{viscosity}, steepness_{1 / (2 * pi * viscosity)} {
    require(viscosity >= least_viscosity && viscosity <= largest_viscosity, problem, "viscosity", viscosity,
            "1e-4..100");
    const double bessel_0 = gsl_sf_bessel_I0_scaled(steepness_);
    for (int n = 1; n <= terms; ++n) {
        bessel_ratio_[static_cast<std::size_t>(n - 1)] = gsl_sf_bessel_In_scaled(n, steepness_) / bessel_0;
    }
}

double Burgers::velocity(double x, double t) const {
    require(std::isfinite(x), problem, "x", x, "the finite numbers");
    require(t >= 0 && t <= largest_time, problem, "time", t, "0..100");
    const Folded point{x};
    if (point.distance == 0) return 0;
    // |u_t / u| is at most pi + nu pi^2 at first: so early, u has not yet changed in its last digit.
    const bool unchanged = t * (pi + viscosity_ * pi * pi) < 0.1 * std::numeric_limits<double>::epsilon();
    if (unchanged) return point.sign * std::sin(pi * point.distance);
    if (viscosity_ * t >= series_from) return point.sign * by_series(point, t);
    return point.sign * by_quadrature(point, t);
}

/// The ratio of integrals, with y = centre +- s (d is the distance of x) folded at the centre: as the initial
/// values are odd and phi is even about it, the two halves make
///     u = Int_0^oo sin(pi s) W(s) (1 - e) ds / Int_0^oo W(s) (1 + e) ds,     e = exp(-4 d s / spread),
///     W(s) = exp[-(d - s)^2 / spread - (1 -+ cos(pi s)) / (2 pi nu)],        spread = 4 nu t,
/// without cancellation where u goes through zero. Both integrands are even and analytic on the whole line,
/// for which the trapezoidal rule is the right one; its points are the multiples of the step.
double Burgers::by_quadrature(const Folded& point, double t) const {
    const double d = point.distance;
    const double spread = 4 * viscosity_ * t;
    const auto exponent = [&](double s) {
        const double initial = point.at_shock ? std::cos(pi / 2 * s) : std::sin(pi / 2 * s);
        return square(s - d) / spread + 2 * steepness_ * square(initial);
    };
    // The least exponent is at most that at x itself, and at most that at the crest of phi (y = 0); nodes
    // farther from x than `reach` have an exponent that exceeds it by `negligible`.
    const double bound = std::min(exponent(d), exponent(point.at_shock ? 1.0 : 0.0));
    const double reach = std::sqrt(spread * (bound + negligible));
    const double step = trapezoidal_step(spread, steepness_);
    const double first = std::max(0.0, std::floor((d - reach) / step));
    const double last = std::ceil((d + reach) / step);

    double least = bound;
    for (double j = first; j <= last; ++j) least = std::min(least, exponent(j * step));
    double numerator = 0;
    double denominator = 0;
    for (double j = first; j <= last; ++j) {
        const double s = j * step;
        const double excess = exponent(s) - least;
        if (excess > negligible) continue;
        const double weight = (j == 0 ? 0.5 : 1.0) * std::exp(-excess);
        const double one_minus_e = -std::expm1(-4 * d * s / spread);
        numerator += weight * std::sin(pi * s) * one_minus_e;
        denominator += weight * (2 - one_minus_e);
    }
    return numerator / denominator;
}

/// The Fourier series of phi, whose coefficients are modified Bessel functions of a = 1 / (2 pi nu):
///     u = 4 pi nu Sum n r_n q^(n^2) sin(n pi x) / [1 + 2 Sum r_n q^(n^2) cos(n pi x)],
///     r_n = I_n(a) / I_0(a),   q = exp(-pi^2 nu t).
double Burgers::by_series(const Folded& point, double t) const {
    // The exponent reaches 700 before u underflows, and its error is the relative error of u: hence long
    // double.
    constexpr long double pi_squared = std::numbers::pi_v<long double> * std::numbers::pi_v<long double>;
    const long double decay = pi_squared * viscosity_ * t;
    double numerator = 0;
    double denominator = 1;
    for (int n = terms; n >= 1; --n) {
        const double parity = point.at_shock && n % 2 != 0 ? -1 : 1;  // cos(n pi) at the shock
        const double amplitude =
            bessel_ratio_[static_cast<std::size_t>(n - 1)] * static_cast<double>(std::exp(-decay * n * n));
        numerator += (point.at_shock ? -parity : parity) * n * amplitude * std::sin(n * pi * point.distance);
        denominator += 2 * parity * amplitude * std::cos(n * pi * point.distance);
    }
    return 4 * pi * viscosity_ * numerator / denominator;
}

}  // namespace exact
