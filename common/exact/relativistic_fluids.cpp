#include "common/exact/relativistic_fluids.hpp"

#include <algorithm>

#include "common/exact/hllc.hpp"
#include "common/exact/require.hpp"

namespace exact {
namespace {

constexpr const char* problem = "relativistic fluid";
constexpr double rounding = 0x1p-52;
/// By which the energy may lie below its least value: fluxes are differences of large numbers.
constexpr double tolerance = 64 * rounding;
constexpr double close = 1e-9;       ///< relative to z: a root is found
constexpr int most_iterations = 60;  ///< more than bisection needs to come close

/// Cells whose roots are sought together, so that the search is vectorised.
struct Search {
    static constexpr std::size_t size = 64;
    double e[size], r[size], z[size], low[size], high[size];
    double open[size];  ///< 1 while the root is not found
};

void start(Search& s, std::size_t n, const RelativisticGas::Columns& conserved) {
    const double *momentum = conserved[0], *tau = conserved[1], *mass = conserved[2];
    for (std::size_t i = 0; i < n; ++i) {
        const double e = tau[i] / mass[i], r = std::abs(momentum[i]) / mass[i];
        const double square = hllc::larger((1 + e - r) * (1 + e + r), 1);
        s.e[i] = e, s.r[i] = r;
        s.z[i] = r / std::sqrt(square);
        s.low[i] = 0, s.high[i] = 2 * r;  // h >= 1 leaves z <= r, but for rounding
    }
}

void improve(Search& s, std::size_t n, double gamma) {
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
        const double z = s.z[i], e = s.e[i], r = s.r[i];
        const double lorentz = std::sqrt(1 + z * z);
        const double u = lorentz * e - z * r + (lorentz - 1), du_dz = z / lorentz * (1 + e) - r;
        const double h = 1 + gamma * u, excess = z * h - r, slope = h + gamma * z * du_dz;
        const double low = excess > 0 ? s.low[i] : z, high = excess > 0 ? z : s.high[i];
        const double newton = z - excess / slope;
        const double next = hllc::both(newton >= low, newton <= high) ? newton : (low + high) / 2;
        s.open[i] = std::abs(next - z) > close * z ? 1 : 0;
        s.low[i] = low, s.high[i] = high, s.z[i] = next;
    }
}

void finish(const Search& s, std::size_t n, double gamma, const RelativisticGas::Columns& conserved,
            const RelativisticGas::Results& primitive) {
    const double *momentum = conserved[0], *mass = conserved[2];
    double *four_velocity = primitive[0], *p = primitive[1], *rho = primitive[2];
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
        const double z = s.z[i], e = s.e[i], r = s.r[i], lorentz = std::sqrt(1 + z * z);
        const double u = lorentz * e - z * r + z * z / (1 + lorentz);
        const double without_heat = r * r / (1 + std::sqrt(1 + r * r));  // the least e: sqrt(1 + r^2) - 1
        const bool physical = hllc::both(mass[i] > 0, e > without_heat * (1 - tolerance));
        const double density = mass[i] / lorentz;
        four_velocity[i] = momentum[i] < 0 ? -z : z;
        rho[i] = density;
        p[i] = physical ? (gamma - 1) * density * hllc::larger(u, rounding * e) : -1;
    }
}

}  // namespace

void RelativisticGas::check() const {
    require(gamma > 1 && gamma <= 2, problem, "gamma", gamma, "(1, 2]");
}
void RelativisticGas::check(const State& s) {
    require(s.rho > 0 && std::isfinite(s.rho), problem, "rho", s.rho, "the finite numbers above 0");
    require(std::abs(s.v) < 1, problem, "v", s.v, "(-1, 1)");
    require(s.p > 0 && std::isfinite(s.p), problem, "p", s.p, "the finite numbers above 0");
}

void RelativisticGas::recover(std::size_t n, const Columns& u, const Results& q) const {
    Search search;
    for (std::size_t i = 0; i < n; i += Search::size) {
        const std::size_t part = std::min(Search::size, n - i);
        const Columns conserved{u[0] + i, u[1] + i, u[2] + i};
        start(search, part, conserved);
        for (int k = 0; k < most_iterations; ++k) {
            improve(search, part, gamma);
            if (hllc::largest(search.open, part) == 0) break;
        }
        finish(search, part, gamma, conserved, {q[0] + i, q[1] + i, q[2] + i});
    }
}

void BaryonFreeFluid::check() const {
    require(c2 > 0 && c2 < 1, problem, "c2", c2, "(0, 1)");
}
void BaryonFreeFluid::check(const State& s) {
    require(s.eps > 0 && std::isfinite(s.eps), problem, "eps", s.eps, "the finite numbers above 0");
    require(std::abs(s.v) < 1, problem, "v", s.v, "(-1, 1)");
}

void BaryonFreeFluid::recover(std::size_t n, const Columns& u, const Results& q) const {
    const double *momentum = u[0], *energy = u[1];
    double *four_velocity = q[0], *root = q[1];
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
        const double e = energy[i], m = momentum[i], b = (1 - c2) * e;
        const double square = (e - m) * (e + m);
        const double eps = 2 * square / (b + std::sqrt(b * b + 4 * c2 * square));
        four_velocity[i] = m / std::sqrt((e + c2 * eps) * (1 + c2) * eps);
        root[i] = hllc::both(e > 0, eps > 0) ? std::sqrt(std::sqrt(eps)) : -1;
    }
}

}  // namespace exact
