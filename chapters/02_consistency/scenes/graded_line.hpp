#pragma once
#include <cmath>
#include <vector>

#include "common/core/vec.hpp"

/// A line of equal masses whose density rises tenfold across the middle, as behind a shock.
namespace sph::consistency {

struct GradedLine {
    static constexpr double rise = 9, width = 0.05, middle = 0.5;

    /// Mass to the left of x, not normalised.
    static double mass_left_of(double x) {
        const auto log_cosh = [](double s) { return std::abs(s) + std::log1p(std::exp(-2 * std::abs(s))); };
        return x + 0.5 * rise * (x + width * (log_cosh((x - middle) / width) - log_cosh(-middle / width)));
    }
    /// Density with a total mass of 1 on [0, 1].
    static double density(double x) {
        return (1 + 0.5 * rise * (1 + std::tanh((x - middle) / width))) / mass_left_of(1);
    }
    /// n positions in [0, 1], each in the middle of its mass 1/n. n >= 1.
    static Column positions(std::size_t n) {
        Column x;
        for (std::size_t i = 0; i < n; ++i) {
            const double wanted = (static_cast<double>(i) + 0.5) / static_cast<double>(n) * mass_left_of(1);
            double low = 0, high = 1;
            for (int k = 0; k < 60; ++k) {  // bisection: to the last digit
                const double mid = 0.5 * (low + high);
                (mass_left_of(mid) < wanted ? low : high) = mid;
            }
            x.push_back(0.5 * (low + high));
        }
        return x;
    }
};

}  // namespace sph::consistency
