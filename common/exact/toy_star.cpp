#include "common/exact/toy_star.hpp"

#include <cmath>

#include "common/exact/require.hpp"

namespace exact {
namespace {

constexpr const char* problem = "toy star";

void require_scale(const char* what, double value) {
    require(value >= ToyStar::least_scale && value <= ToyStar::largest_scale, problem, what, value,
            "1e-6..1e6");
}

/// ln of the initial radius over that at rest, lambda = (B / Omega^2)^(1/(gamma+1)).
/// Throws for parameters out of range.
double checked_log_q0(double gamma, double K, double Omega, double A0, double H0, double C0) {
    require(gamma > 1 && gamma <= ToyStar::largest_gamma, problem, "gamma", gamma, "(1, 100]");
    require_scale("K", K);
    require(Omega >= ToyStar::least_omega && Omega <= ToyStar::largest_omega, problem, "Omega", Omega,
            "1e-3..1e3");
    require(std::fabs(A0) <= ToyStar::largest_rate, problem, "A0", A0, "-1e6..1e6");
    require_scale("H0", H0);
    require_scale("C0", C0);
    const double B = 2 * gamma * K * C0 / (gamma - 1);
    const double log_q0 = -std::log(B / (Omega * Omega)) / (gamma + 1);
    const double swing = ToyStarOrbit::swing(gamma, log_q0, A0 / Omega * std::exp(log_q0));
    constexpr double largest_logarithm = 300;
    require((gamma + 1) * ToyStarOrbit::farthest(gamma, swing) < largest_logarithm, problem, "A0", A0,
            "what this star bears: its C might leave e^-300..e^300 times that of the star at rest");
    return log_q0;
}

}  // namespace

ToyStar::ToyStar(double gamma, double K, double Omega, double A0, double H0, double C0)
    : gamma_{gamma},
      Omega_{Omega},
      H0_{H0},
      C0_{C0},
      log_q0_{checked_log_q0(gamma, K, Omega, A0, H0, C0)},
      orbit_{gamma, log_q0_, A0 / Omega * std::exp(log_q0_)} {}

ToyStar::State ToyStar::at(double t) const {
    require(std::fabs(t) <= largest_time, problem, "time", t, "-1e4..1e4");
    const auto [log_q, speed] = orbit_.at(Omega_ * t);
    const double log_lambda = log_q - log_q0_;
    return {.A = Omega_ * speed * std::exp(-log_q),
            .H = H0_ * std::exp(-(gamma_ - 1) * log_lambda),
            .C = C0_ * std::exp(-(gamma_ + 1) * log_lambda),
            .radius = std::sqrt(H0_ / C0_) * std::exp(log_lambda),
            .gamma = gamma_};
}

double ToyStar::State::density(double x) const {
    if (!(std::fabs(x) < radius)) return 0;
    return std::pow(C * (radius - x) * (radius + x), 1 / (gamma - 1));
}

}  // namespace exact
