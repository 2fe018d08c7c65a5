#include "common/exact/gubser.hpp"

#include <cmath>

#include "common/exact/require.hpp"

namespace exact {

GubserFlow::State GubserFlow::at(double tau, double r) const {
    constexpr const char* problem = "Gubser flow";
    require(q >= 1e-6 && q <= 1e6, problem, "q", q, "1e-6..1e6");
    require(tau >= 1e-6 && tau <= 1e6, problem, "tau", tau, "1e-6..1e6");
    require(r >= 0 && r <= 1e6, problem, "r", r, "0..1e6");
    const double qt = q * tau, qr = q * r, difference = (qt - qr) * (qt + qr);
    const double b = 1 + 2 * (qt * qt + qr * qr) + difference * difference;
    const double eps = std::pow(2 * q, 8.0 / 3) * std::pow(tau * b, -4.0 / 3);
    const double u_tau = (1 + qt * qt + qr * qr) / std::sqrt(b);
    const double temperature = std::sqrt(std::sqrt(eps));
    return {eps, 2 * qt * qr / std::sqrt(b), temperature,
            tau * u_tau * temperature * temperature * temperature};
}

}  // namespace exact
