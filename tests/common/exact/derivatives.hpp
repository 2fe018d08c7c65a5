#pragma once

/// Derivatives of exact solutions, to see whether they obey their equations.
namespace finite_difference {

/// First and second derivative of f at 0 from f(-4h) .. f(4h), errors of order h^8.
struct Derivatives {
    double first, second;
};
inline Derivatives derivatives(double h, const auto& f) {
    constexpr double first[] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
    constexpr double second[] = {8.0 / 5, -1.0 / 5, 8.0 / 315, -1.0 / 560};
    Derivatives sum{0, -205.0 / 72 * f(0.0)};
    for (int k = 1; k <= 4; ++k) {
        sum.first += first[k - 1] * (f(k * h) - f(-k * h));
        sum.second += second[k - 1] * (f(k * h) + f(-k * h));
    }
    return {sum.first / h, sum.second / (h * h)};
}

}  // namespace finite_difference
