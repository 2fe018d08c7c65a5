#pragma once
#include <array>
#include <cstddef>

#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "common/core/vec.hpp"

/// Taylor's series of a function about a particle, cut off at some order, which a local fit solves for, and
/// the functions by which it is multiplied before it is summed: as many as there are unknowns. Any will do
/// that lie within the kernel's support (Chen 2017, 95-104; Ye et al. 2019, 13 and 17). They are functions of
/// xi = x_ji/h, eight neighbours at a time, and h^d times as large as printed, so that all entries of the
/// matrix are of order one.
namespace sph {

/// A term of the series: the product of an earlier term and one coordinate.
struct TaylorTerm {
    std::size_t parent = 0, axis = 0;
    int degree = 0;
    int repeats = 0;       ///< how often `axis` is a factor
    double factorial = 1;  ///< derivative = factorial * coefficient / h^degree: 2 for x^2, 1 for x y
};

/// The monomials of d coordinates up to a degree, by degree: 1; x, y; x^2, x y, y^2; ...
/// Their number is that of the unknowns of a fit: in 1, 2 and 3 dimensions 2, 3, 4 for order 1 and 3, 6, 10
/// for order 2. d = 1, 2, 3; order >= 0.
template <int d, int order>
struct Taylor {
    static constexpr std::size_t count = [] {
        std::size_t n = 1;  // (order + d) over d
        for (int k = 1; k <= d; ++k)
            n = n * static_cast<std::size_t>(order + k) / static_cast<std::size_t>(k);
        return n;
    }();
    static constexpr std::array<TaylorTerm, count> terms = [] {
        std::array<TaylorTerm, count> all{};
        std::size_t end = 1;
        for (std::size_t k = 0; end < count; ++k) {
            for (std::size_t axis = k == 0 ? 0 : all[k].axis; axis < d; ++axis) {
                const int repeats = k > 0 && axis == all[k].axis ? all[k].repeats + 1 : 1;
                all[end++] = {k, axis, all[k].degree + 1, repeats, all[k].factorial * repeats};
            }
        }
        return all;
    }();
    /// All monomials at x, for numbers or tiles.
    template <class T>
    static std::array<T, count> at(const Vec<T, d>& x) {
        std::array<T, count> p;
        p[0] = T(1.0);
        for (std::size_t k = 1; k < count; ++k) p[k] = p[terms[k].parent] * x[terms[k].axis];
        return p;
    }
};

/// Value, gradient and second derivatives: what the equations of this book ask of a fit.
template <int d>
inline constexpr std::size_t derivatives = Taylor<d, 2>::count;

/// W, x W, x^2 W, ...: the basis of the symmetrised finite particle method (Ye et al. 2019, 17). Its matrix
/// is that of weighted least squares: symmetric, and singular only where the neighbours are too few.
struct KernelMoments {
    template <int order, int d>
    static auto at(const Vec<Tile, d>& xi, const AnyKernel<d>& kernel) {
        // [moments]
        auto w = Taylor<d, order>::at(xi);
        const Tile W = kernel.W(dot(xi, xi).sqrt(), 1.0);
        for (Tile& one : w) one = one * W;
        return w;
        // [end]
    }
};

/// W and its derivatives with respect to xi: the basis of the finite particle method (Ye et al. 2019, 13).
/// Orders 1 and 2.
struct KernelDerivatives {
    template <int order, int d>
    static auto at(const Vec<Tile, d>& xi, const AnyKernel<d>& kernel) {
        static_assert(order <= 2, "splines have few derivatives");
        const Tile r2 = dot(xi, xi), r = r2.sqrt();
        const Tile F = kernel.F(r, 1.0);
        std::array<Tile, Taylor<d, order>::count> w;
        w[0] = kernel.W(r, 1.0);
        const Tile along = order > 1 ? (kernel.d2W_dr2(r, 1.0) - F) / r2.max(1e-300) : Tile{};
        for (std::size_t k = 1; k < w.size(); ++k) {
            const TaylorTerm& term = Taylor<d, order>::terms[k];
            if (term.degree == 1) {
                w[k] = xi[term.axis] * F;
            } else {
                const std::size_t a = Taylor<d, order>::terms[term.parent].axis, b = term.axis;
                w[k] = xi[a] * xi[b] * along + (a == b ? F : Tile{});
            }
        }
        return w;
    }
};

}  // namespace sph
