#include "common/exact/shear_instability.hpp"

#include <gsl/gsl_eigen.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "common/exact/require.hpp"

namespace exact {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;
constexpr const char* streams = "sliding streams";
constexpr double wave = 2 * pi;  // k

struct Freed {
    void operator()(gsl_matrix* m) const { gsl_matrix_free(m); }
    void operator()(gsl_vector_complex* v) const { gsl_vector_complex_free(v); }
    void operator()(gsl_matrix_complex* m) const { gsl_matrix_complex_free(m); }
    void operator()(gsl_eigen_nonsymmv_workspace* w) const { gsl_eigen_nonsymmv_free(w); }
};
template <class T>
using Owned = std::unique_ptr<T, Freed>;

/// d/dy at point a by the value at point b, of n on the period 1 (Trefethen, Spectral Methods in MATLAB,
/// chapter 3).
double derivative(std::size_t a, std::size_t b, std::size_t n) {
    if (a == b) return 0;
    const double apart = static_cast<double>(a) - static_cast<double>(b);
    const double sign = (a + b) % 2 == 0 ? 1 : -1;
    return pi * sign / std::tan(pi * apart / static_cast<double>(n));
}

}  // namespace

double ShearInstability::profile(double y) const {
    return std::tanh(std::sin(2 * pi * y) / (2 * pi * flow_.width));
}

ShearInstability::State ShearInstability::base(double y) const {
    const double f = profile(y);
    return {(flow_.inner + flow_.outer) / 2 + f * (flow_.inner - flow_.outer) / 2, flow_.speed * f, 0,
            flow_.pressure};
}

ShearInstability::ShearInstability(const Flow& flow, int points) : flow_{flow} {
    const auto require_positive = [](const char* what, double value) {
        require(value > 0 && std::isfinite(value), streams, what, value, "the positive numbers");
    };
    require(flow.gamma > 1 && flow.gamma <= 100, streams, "gamma", flow.gamma, "(1, 100]");
    require_positive("speed", flow.speed);
    require_positive("inner density", flow.inner);
    require_positive("outer density", flow.outer);
    require_positive("pressure", flow.pressure);
    require(flow.width >= 0.01 && flow.width <= 0.2, streams, "width", flow.width, "0.01..0.2");
    require(points >= 16 && points <= 256 && points % 2 == 0, streams, "points", points,
            "even numbers in 16..256");
    const auto n = static_cast<std::size_t>(points);
    const Owned<gsl_matrix> matrix{gsl_matrix_calloc(3 * n, 3 * n)};
    for (std::size_t a = 0; a < n; ++a) {
        const double y = static_cast<double>(a) / static_cast<double>(n), f = profile(y);
        const State here = base(y);
        const auto set = [&](std::size_t row, std::size_t column, double value) {
            gsl_matrix_set(matrix.get(), row, column, value);
        };
        for (std::size_t block = 0; block < 3; ++block) set(block * n + a, block * n + a, wave * here.v_x);
        set(a, n + a, flow.speed * (1 - f * f) * std::cos(2 * pi * y) / flow.width);
        set(a, 2 * n + a, wave / here.rho);
        set(2 * n + a, a, flow.gamma * flow.pressure * wave);
        for (std::size_t b = 0; b < n; ++b) {
            set(n + a, 2 * n + b, -derivative(a, b, n) / here.rho);
            set(2 * n + a, n + b, flow.gamma * flow.pressure * derivative(a, b, n));
        }
    }
    const Owned<gsl_vector_complex> values{gsl_vector_complex_alloc(3 * n)};
    const Owned<gsl_matrix_complex> vectors{gsl_matrix_complex_alloc(3 * n, 3 * n)};
    const Owned<gsl_eigen_nonsymmv_workspace> room{gsl_eigen_nonsymmv_alloc(3 * n)};
    gsl_eigen_nonsymmv(matrix.get(), values.get(), vectors.get(), room.get());
    std::size_t fastest = 0;
    const auto value = [&](std::size_t k) {
        const gsl_complex z = gsl_vector_complex_get(values.get(), k);
        return Complex{GSL_REAL(z), GSL_IMAG(z)};
    };
    for (std::size_t k = 1; k < 3 * n; ++k) {
        if (value(k).imag() > value(fastest).imag()) fastest = k;
    }
    omega_ = value(fastest);
    const auto component = [&](std::size_t row) {
        const gsl_complex z = gsl_matrix_complex_get(vectors.get(), row, fastest);
        return Complex{GSL_REAL(z), GSL_IMAG(z)};
    };
    double largest = 0;
    Complex scale{1, 0};
    for (std::size_t a = 0; a < n; ++a) {
        if (std::abs(component(n + a)) > largest)
            largest = std::abs(component(n + a)), scale = component(n + a);
    }
    for (Coefficients* of : {&u_, &w_, &p_}) {
        const std::size_t first = of == &u_ ? 0 : of == &w_ ? n : 2 * n;
        for (std::size_t m = 0; m < n; ++m) {
            const double number = static_cast<double>(m) - static_cast<double>(n / 2);
            Complex total{};
            for (std::size_t a = 0; a < n; ++a)
                total += component(first + a) / scale *
                         std::polar(1.0, -2 * pi * number * static_cast<double>(a) / static_cast<double>(n));
            of->push_back(total / static_cast<double>(n));
        }
        (*of)[0] = 0;  // the wave number that n points cannot tell from its negative
    }
}

Complex ShearInstability::sum(const Coefficients& of, double y) const {
    const Complex turn = std::polar(1.0, 2 * pi * y);
    Complex phase = std::polar(1.0, -pi * y * static_cast<double>(of.size())), total{};
    for (const Complex& coefficient : of) total += coefficient * phase, phase *= turn;
    return total;
}

Complex ShearInstability::mode(double y) const {
    return Complex{0, 1} * sum(w_, y);
}

ShearInstability::State ShearInstability::disturbance(double x, double y) const {
    const State here = base(y);
    const double f = profile(y);
    const double slope = (flow_.inner - flow_.outer) / 2 * (1 - f * f) * std::cos(2 * pi * y) / flow_.width;
    const Complex phase = std::polar(1.0, wave * x), w = sum(w_, y), p = sum(p_, y);
    const Complex rho =
        here.rho * p / (flow_.gamma * flow_.pressure) + w * slope / (omega_ - wave * here.v_x);
    return {(rho * phase).real(), (sum(u_, y) * phase).real(), (Complex{0, 1} * w * phase).real(),
            (p * phase).real()};
}

}  // namespace exact
