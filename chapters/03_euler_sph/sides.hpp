#pragma once
#include "chapters/02_consistency/smoothing_lengths.hpp"

/// A pair seen from both sides. Where every particle has its own h, grad_i W_ij(h_i) and grad_i W_ij(h_j)
/// differ, and an equation of motion that follows from a Lagrangian needs both.
namespace sph {

template <int d>
struct SidedPair {
    Vec<Tile, d> x_ij;  ///< x_i - x_j
    Tile r;             ///< distance
    Tile F_i, F_j;      ///< grad_i W_ij(h) = x_ij F(r, h) with the h of either (Monaghan 2005, 5.14)
};

/// The kernel K with the smoothing lengths of both particles.
template <class K>
struct BothH {
    using Reads = List<SmoothingLength>;
    [[no_unique_address]] K kernel{};
    template <int d>
    SidedPair<d> pair(const auto& i, const auto& j, const Vec<Tile, d>& x_ij) const {
        const Tile r = dot(x_ij, x_ij).sqrt();
        return {x_ij, r, kernel.F(r, i.h), kernel.F(r, j.h)};
    }
};

/// The gradient factor with the h of the receiver, and with that of the neighbour; the same where the pair
/// has one h. So one effect serves all smoothings.
const auto& F_i(const auto& pair) {
    if constexpr (requires { pair.F_i; }) {
        return pair.F_i;
    } else {
        return pair.F;
    }
}
const auto& F_j(const auto& pair) {
    if constexpr (requires { pair.F_j; }) {
        return pair.F_j;
    } else {
        return pair.F;
    }
}

}  // namespace sph
