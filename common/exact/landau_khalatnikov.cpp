#include "common/exact/landau_khalatnikov.hpp"

#include <gsl/gsl_integration.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace exact::khalatnikov {
namespace {

using std::numbers::sqrt2;
using std::numbers::sqrt3;

/// Gauss and Legendre's rule on 0..1. The integrands are entire functions that grow like e^(3z): 16 nodes
/// leave less than rounding up to largest_time, where omega is 5.
struct Rule {
    static constexpr std::size_t nodes = 16;
    std::array<double, nodes> place{}, weight{};

    Rule() {
        gsl_integration_glfixed_table* table = gsl_integration_glfixed_table_alloc(nodes);
        for (std::size_t k = 0; k < nodes; ++k)
            gsl_integration_glfixed_point(0, 1, k, &place[k], &weight[k], table);
        gsl_integration_glfixed_table_free(table);
    }
};

/// I0(q) and I1(q)/q by their power series. They are entire functions of q^2: 0 is nothing special, nor is
/// q^2 < 0, where a step of Newton's method may go. A third faster than GSL's functions of q.
struct Bessel {
    double I0, I1_q;
};
Bessel bessel(double q2) {
    constexpr int terms = 20;  // leave less than 1e-20 up to largest_time
    double I0 = 1, I1 = 1;
    for (int k = terms; k > 0; --k) {
        I0 = 1 + q2 / (4 * k * k) * I0;
        I1 = 1 + q2 / (4 * k * (k + 1)) * I1;
    }
    return {I0, I1 / 2};
}

/// Calls add(weight dz, z, Bessel functions at q(z)) at the nodes of the integral from a to omega.
void integrate(double a, double omega, const auto& add) {
    static const Rule rule;
    for (std::size_t k = 0; k < Rule::nodes; ++k) {
        const double above = (omega - a) * rule.place[k], z = a + above;
        add((omega - a) * rule.weight[k], z, bessel(above * (z + a)));
    }
}

struct Potential {
    double U, V;
};
Potential potential(const State& state) {
    const double a = state.y / sqrt3, half = std::sinh(state.y / 2);
    double U = 0, V = 0;
    integrate(a, state.omega, [&](double dz, double z, const Bessel& f) {
        const double part = dz * std::exp(2 * z);
        U += part * (f.I0 + z * f.I1_q);
        V += part * f.I1_q;
    });
    return {sqrt3 * (std::exp(2 * a) + U) - std::sinh(state.y), std::expm1(2 * a) - 2 * half * half + a * V};
}

/// How far a state is from where it should be, and Newton's step that takes it there.
struct Miss {
    double eta, log_tau;
    State step;

    double size() const { return std::hypot(eta, log_tau); }
};
Miss miss(const State& state, double eta, double log_tau) {
    const auto [U, V] = potential(state);
    const double a = state.y / sqrt3, growth = std::exp(2 * state.omega);
    const auto [I0, I1_q] = bessel((state.omega - a) * (state.omega + a));
    const double dU = sqrt3 * growth * (I0 + state.omega * I1_q), dV = a * growth * I1_q;  // by omega
    const double plus = U - V, minus = U + V;  // e^-y (t + x), e^y (t - x)
    const double eta_miss = state.y - std::log1p(2 * V / plus) / 2 - eta;
    const double tau_miss = (std::log(plus) + std::log(minus)) / 2 - log_tau;
    // By omega and y, times U^2 - V^2, which they share with their determinant. Those that are odd in y keep
    // their digits where it is small.
    const double eta_omega = V * dU - U * dV, eta_y = U * dU / 3 - V * dV;
    const double tau_omega = U * dU - V * dV, tau_y = V * dU / 3 - U * dV;
    const double determinant = dU * dU / 3 - dV * dV;
    return {eta_miss,
            tau_miss,
            {(tau_y * eta_miss - eta_y * tau_miss) / determinant,
             (eta_omega * tau_miss - tau_omega * eta_miss) / determinant}};
}

}  // namespace

/// Newton's method for the logarithm of t, which is convex and rises at least as fast as omega: from above.
State weak_discontinuity(double t) {
    constexpr int enough = 50;
    constexpr double small = 1e-9;  // leaves its square
    const double A = std::atanh(1 / sqrt3);
    double omega = std::log(t / sqrt3);
    for (int k = 0; k < enough; ++k) {
        const double argument = sqrt3 * omega - A;
        const double excess = 2 * omega + std::log(sqrt2 * std::cosh(argument) / t);
        const double step = excess / (2 + sqrt3 * std::tanh(argument));
        omega -= step;
        if (std::fabs(step) <= small) break;
    }
    return {omega, sqrt3 * omega};
}

State state_at(double t, double x, const State& guess) {
    constexpr int enough = 50;
    constexpr double small = 1e-9;  // leaves its square
    const double eta = std::log1p(2 * x / (t - x)) / 2, log_tau = (std::log(t - x) + std::log(t + x)) / 2;
    State state = guess;
    Miss now = miss(state, eta, log_tau);
    for (int k = 0; k < enough; ++k) {
        State next{state.omega + now.step.omega, state.y + now.step.y};
        if (std::fabs(now.step.omega) <= small && std::fabs(now.step.y) <= small) return next;
        Miss after = miss(next, eta, log_tau);
        // As the determinant is positive, some part of the step leads nearer.
        for (double part = 0.5; !(after.size() < now.size()) && part > small; part /= 2) {
            next = {state.omega + part * now.step.omega, state.y + part * now.step.y};
            after = miss(next, eta, log_tau);
        }
        state = next;
        now = after;
    }
    return state;
}

double entropy_beyond(const State& state) {
    const double a = state.y / sqrt3;
    double sum = 0;
    integrate(a, state.omega,
              [&](double dz, double z, const Bessel& f) { sum += dz * std::exp(-z) * f.I1_q; });
    return std::exp(-a) + a * sum;
}

}  // namespace exact::khalatnikov
