#pragma once
#include <vector>

/// The competitor: central differences, which know their neighbours by index. All on [0, 1) with period 1.
namespace sph::interpolation {

/// dA/dx on even points of spacing 1/n, second order: (A_{i+1} - A_{i-1}) / (2 dx). Cost O(n).
inline void central_2(const std::vector<double>& A, std::vector<double>& slope) {
    const std::size_t n = A.size();
    const double scale = 0.5 * static_cast<double>(n);
    for (std::size_t i = 1; i + 1 < n; ++i) slope[i] = scale * (A[i + 1] - A[i - 1]);
    slope[0] = scale * (A[1] - A[n - 1]);
    slope[n - 1] = scale * (A[0] - A[n - 2]);
}

/// dA/dx on even points of spacing 1/n, fourth order: (8 (A_{i+1} - A_{i-1}) - (A_{i+2} - A_{i-2})) / (12
/// dx).
inline void central_4(const std::vector<double>& A, std::vector<double>& slope) {
    const std::size_t n = A.size();
    const double scale = static_cast<double>(n) / 12;
    const auto at = [&](std::size_t right, std::size_t left, std::size_t right2, std::size_t left2) {
        return scale * (8 * (A[right] - A[left]) - (A[right2] - A[left2]));
    };
    for (std::size_t i = 2; i + 2 < n; ++i) slope[i] = at(i + 1, i - 1, i + 2, i - 2);
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}, n - 2, n - 1}) {
        slope[i] = at((i + 1) % n, (i + n - 1) % n, (i + 2) % n, (i + n - 2) % n);
    }
}

/// dA/dx on sorted uneven points x: the parabola through three neighbours, second order on any spacing.
inline void three_point(const std::vector<double>& x, const std::vector<double>& A,
                        std::vector<double>& slope) {
    const std::size_t n = A.size();
    const auto at = [&](double a, double b, double left,
                        double right) {  // a, b: distances to both neighbours
        return (a * a * right - b * b * left) / (a * b * (a + b));
    };
    for (std::size_t i = 1; i + 1 < n; ++i) {
        slope[i] = at(x[i] - x[i - 1], x[i + 1] - x[i], A[i - 1] - A[i], A[i + 1] - A[i]);
    }
    slope[0] = at(x[0] - x[n - 1] + 1, x[1] - x[0], A[n - 1] - A[0], A[1] - A[0]);
    slope[n - 1] = at(x[n - 1] - x[n - 2], x[0] + 1 - x[n - 1], A[n - 2] - A[n - 1], A[0] - A[n - 1]);
}

/// Both components of grad A on an even n x n lattice (row by row, x fastest), second order.
inline void central_gradient_2d(const std::vector<double>& A, std::size_t n, std::vector<double>& slope_x,
                                std::vector<double>& slope_y) {
    const double scale = 0.5 * static_cast<double>(n);
    for (std::size_t row = 0; row < n; ++row) {
        const double* here = A.data() + row * n;
        const double* above = A.data() + (row + 1 == n ? 0 : row + 1) * n;
        const double* below = A.data() + (row == 0 ? n - 1 : row - 1) * n;
        double* out_x = slope_x.data() + row * n;
        double* out_y = slope_y.data() + row * n;
        for (std::size_t i = 0; i < n; ++i) out_y[i] = scale * (above[i] - below[i]);
        for (std::size_t i = 1; i + 1 < n; ++i) out_x[i] = scale * (here[i + 1] - here[i - 1]);
        out_x[0] = scale * (here[1] - here[n - 1]);
        out_x[n - 1] = scale * (here[0] - here[n - 2]);
    }
}

}  // namespace sph::interpolation
