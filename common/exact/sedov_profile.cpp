#include "common/exact/sedov_profile.hpp"

#include <cmath>

#include "common/exact/require.hpp"

namespace exact {
namespace {

constexpr const char* problem = "point blast";

}  // namespace

SedovProfile::SedovProfile(int dimension, double gamma) : dimension_{dimension}, gamma_{gamma} {
    require(dimension >= 1 && dimension <= 3, problem, "dimension", dimension, "1..3");
    require(gamma >= least_gamma && gamma <= largest_gamma, problem, "gamma", gamma, "1.001..100");
    require(gamma < vacuum_gamma || dimension < 3, problem, "gamma", gamma,
            "1.001..7, 7 excluded, in three dimensions (a vacuum opens at the centre)");
    const double d = dimension;
    const double M = 2 * (gamma - 1) + d;
    const double N = 2 + d * (gamma - 1);
    const double D = 3 * d - 2 - (d - 2) * gamma;  // exact to rounding where it goes to 0
    k1_ = (gamma - 1) / (2 * gamma);
    k3_ = (gamma - 1) * N / (gamma * D);
    a0_ = 2 / (d + 2);
    a1_ = (d + 2) * gamma / N * (2 * d * (2 - gamma) / (gamma * (d + 2) * (d + 2)) + (gamma - 1) / M);
    a2_ = (gamma - 1) / M;
    rho_y_ = d / M;
    rho_x3_ = (d - 2) * D / (M * N);
    q0_ = d * (gamma + 1) / (gamma * D);
}

double SedovProfile::log_lambda(double log_y) const {
    const double z = -std::expm1(log_y);
    return -a0_ * std::log1p(-k1_ * z) + a2_ * log_y - a1_ * std::log1p(k3_ * z);
}

double SedovProfile::slope(double log_y) const {
    const double y = std::exp(log_y), z = -std::expm1(log_y);
    return a2_ + y * (a1_ * k3_ / (1 + k3_ * z) - a0_ * k1_ / (1 - k1_ * z));
}

/// Newton's method from the shock, or a bisection where a step leaves the interval that is left. The last
/// step is a Newton step below 1e-10 of log_y, which leaves 1e-20 of it. For lambda = 0 the first one goes to
/// -infinity and is the last.
double SedovProfile::log_y_at(double wanted) const {
    constexpr int enough = 300;
    constexpr double small = 1e-10;
    // x1 >= 1 - k1 and x3 >= 1, so that log_lambda(low) <= wanted.
    double low = (wanted + a0_ * std::log1p(-k1_)) / a2_, high = 0, log_y = 0;
    for (int k = 0; k < enough; ++k) {
        const double excess = log_lambda(log_y) - wanted;
        (excess > 0 ? high : low) = log_y;
        const double newton = log_y - excess / slope(log_y);
        const bool inside = newton >= low && newton <= high;
        if (inside && std::fabs(newton - log_y) <= small * std::fabs(newton)) return newton;
        log_y = inside ? newton : (low + high) / 2;
    }
    return log_y;
}

SedovProfile::Ratio SedovProfile::ratio(double log_y) const {
    const double z = -std::expm1(log_y);
    const double log_x1 = std::log1p(-k1_ * z), log_x3 = std::log1p(k3_ * z), log_x4 = std::log1p(z / gamma_);
    // ln(x4/x3), of which either form loses its digits where the other one has them.
    const double epsilon = 2 - gamma_, q = q0_ * z / (1 + k3_ * z);
    const double log_x43 = std::fabs(epsilon * q) < 0.5 ? std::log1p(epsilon * q) : log_x4 - log_x3;
    const double last = -2 * (epsilon == 0 ? q : log_x43 / epsilon);
    const double log_rho = rho_y_ * log_y + rho_x3_ * log_x3 + last;
    // v^2/y without ln y: its power is that of 1/rho and cancels in p.
    const double log_p = dimension_ * a0_ * log_x1 + (rho_x3_ - 2 * a1_) * log_x3 + log_x4 + last;
    return {std::exp(log_rho), std::exp(log_x1 + log_lambda(log_y)), std::exp(log_p),
            std::exp(log_p - log_rho)};
}

SedovProfile::Ratio SedovProfile::at(double lambda) const {
    require(lambda >= 0 && lambda <= 1, problem, "lambda", lambda, "0..1");
    return ratio(log_y_at(std::log(lambda)));
}

/// Over ln lambda as a function of t = ln(-ln y), where no root has to be found, by the trapezoidal rule: the
/// integrand is analytic for |Im t| < pi/2 and falls exponentially on both sides, which leaves
/// e^(-pi^2/step). As t -> -infinity, at the shock, it falls with e^t, from where 1 = k3 z on: 2^-53 at the
/// nearest to gamma = 7; at the centre with exp(-d a2 e^t).
double SedovProfile::energy_integral() const {
    constexpr double step = 0.25, from = -80, negligible = 50;
    double sum = 0;
    for (double t = from; dimension_ * a2_ * std::exp(t) < negligible; t += step) {
        const double log_y = -std::exp(t);
        const auto [rho, v, p, u] = ratio(log_y);
        sum += (rho * v * v + p) * std::exp(dimension_ * log_lambda(log_y)) * slope(log_y) * -log_y;
    }
    return step * sum;
}

}  // namespace exact
