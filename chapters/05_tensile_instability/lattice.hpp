#pragma once
#include <cmath>
#include <vector>

#include "chapters/01_kernel_interpolation/kernel.hpp"
#include "common/core/dense.hpp"

/// The neighbours of a particle in a square lattice of spacing 1, and what a kernel makes of them: all that
/// the linear theory of a lattice needs to know of the kernel.
namespace sph {

/// A kernel on the square lattice of spacing 1 in d dimensions, with one smoothing length h [spacings].
template <int d>
struct LatticeKernel {
    /// A neighbour at x, with W, grad W and the matrix of second derivatives of W there.
    struct Neighbour {
        Vector<d> x{}, gradient{};
        Tensor<d> hessian{};
    };
    std::vector<Neighbour> half;  ///< inside the support: of each pair at r and -r one
    double density = 0;           ///< sum_j W, the particle itself included: that of unit masses
};

namespace lattice_detail {

/// grad grad W = F 1 + (W'' - F) x x^T/r^2, since grad W = x F.
template <class K>
typename LatticeKernel<K::dimension>::Neighbour neighbour(const Vector<K::dimension>& x, double h) {
    const double r2 = dot(x, x), r = std::sqrt(r2);
    const double F = K::F(r, h), along = (K::d2W_dr2(r, h) - F) / r2;
    auto hessian = along * outer(x, x);
    for (std::size_t a = 0; a < x.size(); ++a) hessian[a][a] += F;
    return {x, F * x, hessian};
}

}  // namespace lattice_detail

/// The neighbours of a particle of the lattice with the kernel K. h > 0 [spacings].
/// Cost: (2 support h + 1)^d terms.
template <class K>
LatticeKernel<K::dimension> lattice_kernel(double h) {
    constexpr int d = K::dimension;
    const int last = static_cast<int>(std::ceil(K::support * h)), side = 2 * last + 1;
    int n = 1;
    for (int axis = 0; axis < d; ++axis) n *= side;
    LatticeKernel<d> lattice;
    for (int index = 0; index < n; ++index) {
        Vector<d> x;
        for (int axis = 0, rest = index; axis < d; ++axis, rest /= side)
            x[static_cast<std::size_t>(axis)] = rest % side - last;
        const double r = std::sqrt(dot(x, x));
        if (r >= K::support * h) continue;
        lattice.density += K::W(r, h);
        if (index > n / 2) lattice.half.push_back(lattice_detail::neighbour<K>(x, h));
    }
    return lattice;
}

}  // namespace sph
