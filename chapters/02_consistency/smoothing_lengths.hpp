#pragma once
#include <cmath>

#include "chapters/02_consistency/moments.hpp"

/// Smoothing lengths that follow the particles: one for all from the mean density, or one for each; and how
/// the two h of a pair become one kernel (Chen 2017, section 1.6.3).
namespace sph {

/// h = h_over_dx (m/<rho>)^(1/d), <rho> the mean of the particles' densities   (Chen 2017, 59, where the mass
/// is missing and h_over_dx is called eta). `rho`: at least one, all > 0; m > 0; h_over_dx > 0.
inline double mean_density_h(const Column& rho, double m, double h_over_dx, int d) {
    double mean = 0;
    for (const double value : rho) mean += value / static_cast<double>(rho.size());
    return h_over_dx * std::pow(m / mean, 1.0 / d);
}

/// W(r, h_i): each particle gathers with its own h. Not symmetric: i may see j unseen, and forces do not
/// cancel.
template <class K>
struct OwnH {
    using ReadsI = List<SmoothingLength>;
    [[no_unique_address]] K kernel{};
    template <int d>
    Pair<d, double> pair(const auto& i, const auto&, const Vec<Tile, d>& x_ij) const {
        return ConstantH<K>{i.h, kernel}.pair(i, i, x_ij);
    }
};

/// W(r, (h_i + h_j)/2)   (Chen 2017, 60)
template <class K>
struct MeanH {
    using Reads = List<SmoothingLength>;
    [[no_unique_address]] K kernel{};
    template <int d>
    Pair<d, Tile> pair(const auto& i, const auto& j, const Vec<Tile, d>& x_ij) const {
        const Tile r = dot(x_ij, x_ij).sqrt(), h = 0.5 * (i.h + j.h);
        return {x_ij, r, kernel.W(r, h), kernel.F(r, h), kernel.d2W_dr2(r, h), h};
    }
};

/// (W(r, h_i) + W(r, h_j))/2   (Chen 2017, 61)
template <class K>
struct MeanKernel {
    using Reads = List<SmoothingLength>;
    [[no_unique_address]] K kernel{};
    template <int d>
    Pair<d, Tile> pair(const auto& i, const auto& j, const Vec<Tile, d>& x_ij) const {
        const Tile r = dot(x_ij, x_ij).sqrt();
        return {x_ij,
                r,
                0.5 * (kernel.W(r, i.h) + kernel.W(r, j.h)),
                0.5 * (kernel.F(r, i.h) + kernel.F(r, j.h)),
                0.5 * (kernel.d2W_dr2(r, i.h) + kernel.d2W_dr2(r, j.h)),
                0.5 * (i.h + j.h)};
    }
};

}  // namespace sph
