#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "chapters/01_kernel_interpolation/kernel.hpp"
#include "common/core/dense.hpp"

/// The neighbours of a particle in a lattice of unit cells, and what a kernel makes of them: all that the
/// linear theory of a lattice needs to know of the kernel.
namespace sph {

/// A lattice in d dimensions by its basis vectors; the cell that they span has the volume 1 (and dx = 1).
template <int d>
Tensor<d> square_lattice() {
    Tensor<d> basis;
    for (std::size_t a = 0; a < d; ++a) basis[a][a] = 1;
    return basis;
}
/// The densest lattice of the plane: six neighbours at the distance sqrt(2/sqrt(3)) = 1.075.
inline Tensor<2> hexagonal_lattice() {
    const double spacing = std::sqrt(2 / std::sqrt(3.0));
    return {Vector<2>{spacing, 0}, Vector<2>{spacing / 2, 1 / spacing}};
}
/// The vectors b_a with b_a . basis_c = delta_ac: wave vectors 2 pi b_a are the shortest that the lattice
/// cannot tell from k = 0.
template <int d>
Tensor<d> reciprocal(const Tensor<d>& basis) {
    Tensor<d> result;
    for (std::size_t a = 0; a < d; ++a) {
        Vector<d> unit;
        unit[a] = 1;
        result[a] = inverse_times<d>(basis, unit);
    }
    return result;
}

/// A kernel on a lattice, with one smoothing length h [dx].
template <int d>
struct LatticeKernel {
    /// A neighbour at x, with W, grad W and the matrix of second derivatives of W there.
    struct Neighbour {
        Vector<d> x{}, gradient{};
        Tensor<d> hessian{};
    };
    Tensor<d> basis = square_lattice<d>();
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

/// The neighbours of a particle of that lattice with the kernel K. h > 0 [dx].
/// Cost: some (2 support h + 1)^d terms.
template <class K>
LatticeKernel<K::dimension> lattice_kernel(
    double h, const Tensor<K::dimension>& basis = square_lattice<K::dimension>()) {
    constexpr int d = K::dimension;
    // As many cells along each basis vector as the planes across it lie within the support.
    double planes = 0;
    for (const auto& b : reciprocal<d>(basis)) planes = std::max(planes, std::sqrt(dot(b, b)));
    const int last = static_cast<int>(std::ceil(K::support * h * planes)), side = 2 * last + 1;
    int n = 1;
    for (int axis = 0; axis < d; ++axis) n *= side;
    LatticeKernel<d> lattice;
    lattice.basis = basis;
    for (int index = 0; index < n; ++index) {
        Vector<d> x;
        for (int axis = 0, rest = index; axis < d; ++axis, rest /= side)
            x += double(rest % side - last) * basis[static_cast<std::size_t>(axis)];
        const double r = std::sqrt(dot(x, x));
        if (r >= K::support * h) continue;
        lattice.density += K::W(r, h);
        if (index > n / 2) lattice.half.push_back(lattice_detail::neighbour<K>(x, h));
    }
    return lattice;
}

}  // namespace sph
