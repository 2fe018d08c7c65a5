#include "common/report/norms.hpp"

#include <cmath>
#include <stdexcept>

namespace report {
namespace {

void require_same_length(Span value, Span exact, Span weight) {
    if (exact.empty()) throw std::invalid_argument{"error norm: no values"};
    if (value.size() != exact.size()) throw std::invalid_argument{"error norm: lengths differ"};
    if (!weight.empty() && weight.size() != exact.size())
        throw std::invalid_argument{"error norm: as many weights as values are needed"};
}

double relative(double error, double scale) {
    if (scale == 0) throw std::invalid_argument{"error norm: the exact values are all zero"};
    return error / scale;
}

/// The larger one; NaN if either is: std::max would lose it, and a failed run would look exact.
double larger(double a, double b) {
    return a > b || std::isnan(a) ? a : b;
}

void require_positive(double n, double error) {
    if (!(n > 0) || !(error > 0)) throw std::invalid_argument{"observed order: n and error must be positive"};
}

}  // namespace

double l1_error(Span value, Span exact, Span weight) {
    require_same_length(value, exact, weight);
    double error = 0, scale = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const double dx = weight.empty() ? 1 : weight[i];
        error += std::abs(value[i] - exact[i]) * dx;
        scale += std::abs(exact[i]) * dx;
    }
    return relative(error, scale);
}

double l2_error(Span value, Span exact, Span weight) {
    require_same_length(value, exact, weight);
    double error = 0, scale = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const double dx = weight.empty() ? 1 : weight[i];
        const double difference = value[i] - exact[i];
        error += difference * difference * dx;
        scale += exact[i] * exact[i] * dx;
    }
    return std::sqrt(relative(error, scale));
}

double linf_error(Span value, Span exact) {
    require_same_length(value, exact, {});
    double error = 0, scale = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        error = larger(error, std::abs(value[i] - exact[i]));
        scale = larger(scale, std::abs(exact[i]));
    }
    return relative(error, scale);
}

double SquaredError::relative() const {
    return std::sqrt(error_ / size_);
}

double observed_order(double n1, double e1, double n2, double e2) {
    require_positive(n1, e1);
    require_positive(n2, e2);
    if (n1 == n2) throw std::invalid_argument{"observed order: two different resolutions are needed"};
    return std::log(e1 / e2) / std::log(n2 / n1);
}

double fitted_order(Span n, Span error) {
    if (n.size() != error.size() || n.size() < 2)
        throw std::invalid_argument{"observed order: as many errors as resolutions are needed, at least two"};
    const auto count = static_cast<double>(n.size());
    double mean_x = 0, mean_y = 0;
    for (std::size_t i = 0; i < n.size(); ++i) {
        require_positive(n[i], error[i]);
        mean_x += std::log(n[i]) / count;
        mean_y += std::log(error[i]) / count;
    }
    double xx = 0, xy = 0;
    for (std::size_t i = 0; i < n.size(); ++i) {
        const double x = std::log(n[i]) - mean_x;
        xx += x * x;
        xy += x * (std::log(error[i]) - mean_y);
    }
    if (xx == 0) throw std::invalid_argument{"observed order: two different resolutions are needed"};
    return -xy / xx;
}

}  // namespace report
