#pragma once
#include "chapters/01_kernel_interpolation/kernel.hpp"
#include "common/core/particles.hpp"
#include "common/core/tile.hpp"

namespace sph {

/// What the equations may use of a pair: eight neighbours at once. What no listed effect uses, the compiler
/// removes.
template <int d, class H>
struct Pair {
    Vec<Tile, d> x_ij;  ///< x_i - x_j
    Tile r, W, F, d2W;  ///< distance, W, gradient factor (grad_i W = x_ij F), d2W/dr2
    H h;                ///< the smoothing length: of all, or of each pair
};

/// One smoothing length for all particles, with the kernel K.
template <class K>
struct ConstantH {
    double h;  ///< > 0, in the unit of positions
    [[no_unique_address]] K kernel{};

    template <int d>
    Pair<d, double> pair(const auto&, const auto&, const Vec<Tile, d>& x_ij) const {
        const Tile r = dot(x_ij, x_ij).sqrt();
        return {x_ij, r, kernel.W(r, h), kernel.F(r, h), kernel.d2W_dr2(r, h), h};
    }
    double reach() const { return kernel.support * h; }
};

}  // namespace sph
