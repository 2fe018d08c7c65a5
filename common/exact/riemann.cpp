#include "common/exact/riemann.hpp"

#include <algorithm>
#include <cmath>

#include "common/exact/require.hpp"

namespace exact {
namespace {

using Real = long double;
constexpr const char* problem = "Riemann problem";

/// One side of the problem, as if it were the left one.
struct Side {
    Real rho, v, p, gamma, c;

    Side(const Riemann::State& state, double adiabatic_index, double direction)
        : rho{state.rho},
          v{direction * Real{state.v}},
          p{state.p},
          gamma{adiabatic_index},
          c{state.rho > 0 ? std::sqrt(gamma * p / rho) : 0} {}

    bool empty() const { return rho == 0; }
    /// (p_star/p)^((gamma - 1)/(2 gamma)), minus 1.
    Real expansion(Real p_star) const { return std::expm1((gamma - 1) / (2 * gamma) * std::log(p_star / p)); }
    /// f_K: the change of velocity across the wave that leads to p_star.
    Real velocity_change(Real p_star) const {
        if (p_star <= p) return p > 0 ? 2 * c / (gamma - 1) * expansion(p_star) : 0;
        return (p_star - p) * std::sqrt(A() / (p_star + B()));
    }
    Real slope(Real p_star) const {
        if (p_star <= p) return std::exp(-(gamma + 1) / (2 * gamma) * std::log(p_star / p)) / (rho * c);
        return std::sqrt(A() / (p_star + B())) * (1 - (p_star - p) / (2 * (p_star + B())));
    }
    Real star_density(Real p_star) const {
        if (p_star <= p) return p > 0 ? rho * std::exp(std::log(p_star / p) / gamma) : rho;
        const Real mu = (gamma - 1) / (gamma + 1);
        return rho * (p_star + mu * p) / (mu * p_star + p);
    }
    /// Velocity of the front into vacuum, on the side towards the other state.
    Real front() const { return v + 2 * c / (gamma - 1); }
    Real A() const { return 2 / ((gamma + 1) * rho); }
    Real B() const { return (gamma - 1) / (gamma + 1) * p; }

    Riemann::Point point(Real density, Real velocity, Real pressure) const {
        const Real u = density > 0 ? pressure / ((gamma - 1) * density) : 0;
        return {static_cast<double>(density), static_cast<double>(velocity), static_cast<double>(pressure),
                static_cast<double>(u)};
    }
    Riemann::Point undisturbed() const { return point(rho, v, p); }
    /// Inside the rarefaction fan at x/t = xi.
    Riemann::Point fan(Real xi) const {
        const Real part = 2 / (gamma + 1) + (gamma - 1) / (gamma + 1) * (v - xi) / c;  // c(xi)/c
        const Real log_c = std::log(part);
        return point(rho * std::exp(2 / (gamma - 1) * log_c),
                     2 / (gamma + 1) * (c + (gamma - 1) / 2 * v + xi),
                     p * std::exp(2 * gamma / (gamma - 1) * log_c));
    }
    /// Where the wave to the star state begins and ends.
    struct Edges {
        Real head, tail;
    };
    Edges edges(Real p_star, Real v_star) const {
        if (p_star > p) {
            const Real shock = v - std::sqrt(((gamma + 1) / 2 * p_star + (gamma - 1) / 2 * p) / rho);
            return {shock, shock};
        }
        return {v - c, p > 0 ? v_star - c * (1 + expansion(p_star)) : v};
    }
    /// The state at xi, left of the contact.
    Riemann::Point at(Real xi, Real p_star, Real v_star, Real rho_star) const {
        const auto [head, tail] = edges(p_star, v_star);
        if (xi < head) return undisturbed();
        return xi < tail ? fan(xi) : point(rho_star, v_star, p_star);
    }
    /// The state at xi beside a vacuum.
    Riemann::Point beside_vacuum(Real xi) const {
        if (empty() || xi >= front()) return {0, 0, 0, 0};
        return xi < v - c ? undisturbed() : fan(xi);
    }
};

/// The root: between two rarefactions in closed form, else by Newton's method in a bracket.
Real star_pressure(const Side& l, const Side& r, Real closing) {
    const Real exponent = (l.gamma - 1) / (2 * l.gamma);
    if (l.p == 0 && r.p == 0 && closing == 0) return 0;  // cold gas that touches
    if (l.p > 0 && r.p > 0) {
        // Scaled by the larger pressure, so that no power over- or underflows.
        const Real scale = std::max(l.p, r.p);
        const Real both = l.c * std::pow(scale / l.p, exponent) + r.c * std::pow(scale / r.p, exponent);
        const Real root = (l.c + r.c + (l.gamma - 1) / 2 * closing) / both;
        const Real p = scale * std::pow(root, 1 / exponent);
        if (p <= std::min(l.p, r.p)) return p;
    }
    const auto f = [&](Real p) { return l.velocity_change(p) + r.velocity_change(p) - closing; };
    Real low = std::min(l.p, r.p), high = std::max(l.p, r.p);
    if (f(high) < 0) {
        low = high;
        // As strong shocks would have it, which is not less than the root.
        high = std::max(high, std::pow(closing / (std::sqrt(l.A()) + std::sqrt(r.A())), Real{2}));
        while (f(high) < 0) high *= 4;
    }
    Real p = high;
    for (int step = 0; step < 200; ++step) {
        const Real value = f(p);
        (value < 0 ? low : high) = p;
        Real next = p - value / (l.slope(p) + r.slope(p));
        if (!(next > low && next < high)) next = low > 0 ? std::sqrt(low) * std::sqrt(high) : high / 16;
        if (std::abs(next - p) <= 2e-19L * p) return next;
        p = next;
    }
    return p;
}

/// The wave of one side; `direction` is 1 for the left one, -1 for the right one, which Side sees mirrored.
Riemann::Wave wave(const Side::Edges& edges, double direction, bool shock) {
    return {direction * static_cast<double>(edges.head), direction * static_cast<double>(edges.tail), shock};
}
/// That into a vacuum; beside an empty side, where there is no wave, the front of the gas on the other one.
Riemann::Wave wave_into_vacuum(const Side& side, const Side& other, double direction) {
    if (side.empty()) return wave({-other.front(), -other.front()}, direction, false);
    return wave({side.v - side.c, side.front()}, direction, false);
}

}  // namespace

Riemann::Riemann(const State& left, const State& right, double gamma)
    : left_{left}, right_{right}, gamma_{gamma} {
    require(gamma > 1 && gamma <= largest_gamma, problem, "gamma", gamma, "(1, 100]");
    for (const State& state : {left, right}) {
        require(state.rho >= 0 && state.rho <= largest_scale, problem, "rho", state.rho, "0..1e100");
        require(std::fabs(state.v) <= largest_scale, problem, "v", state.v, "-1e100..1e100");
        require(state.p >= 0 && state.p <= largest_scale, problem, "p", state.p, "0..1e100");
        require(state.rho > 0 || state.p == 0, problem, "p in a vacuum", state.p, "0");
    }
    require(left.rho > 0 || right.rho > 0, problem, "rho of both sides", 0, "rho > 0 on one side at least");
    const Side l{left, gamma, 1}, r{right, gamma, -1};
    const Real closing = l.v + r.v;  // v_L - v_R
    const Real fastest = 2 * (l.c + r.c) / (l.gamma - 1);
    if (l.empty() || r.empty() || -closing > fastest || (-closing == fastest && fastest > 0)) {
        const Real from = l.empty() ? -r.front() : l.front(), to = r.empty() ? l.front() : -r.front();
        star_ = {0, static_cast<double>((from + to) / 2), 0, 0, true};
        waves_ = {wave_into_vacuum(l, r, 1), star_.v, wave_into_vacuum(r, l, -1)};
        return;
    }
    const Real p = star_pressure(l, r, closing);
    const Real v = (l.v - r.v + (r.velocity_change(p) - l.velocity_change(p))) / 2;
    star_ = {static_cast<double>(p), static_cast<double>(v), static_cast<double>(l.star_density(p)),
             static_cast<double>(r.star_density(p)), false};
    waves_ = {wave(l.edges(p, v), 1, p > l.p), star_.v, wave(r.edges(p, -v), -1, p > r.p)};
}

Riemann::Point Riemann::at(double xi) const {
    require(std::isfinite(xi), problem, "x/t", xi, "the finite numbers");
    const bool from_left = xi < star_.v;
    const Side side{from_left ? left_ : right_, gamma_, from_left ? 1.0 : -1.0};
    const Real x = from_left ? Real{xi} : -Real{xi};
    const Real v = from_left ? Real{star_.v} : -Real{star_.v};
    Point point = star_.vacuum ? side.beside_vacuum(x)
                               : side.at(x, star_.p, v, from_left ? star_.rho_left : star_.rho_right);
    if (!from_left) point.v = -point.v;
    return point;
}

Riemann::Point Riemann::at(double x, double t) const {
    require(std::isfinite(x), problem, "x", x, "the finite numbers");
    require(t >= 0, problem, "time", t, "0 and above");
    if (t > 0) return at(x / t);
    const Side side{x < 0 ? left_ : right_, gamma_, 1};
    return side.undisturbed();
}

}  // namespace exact
