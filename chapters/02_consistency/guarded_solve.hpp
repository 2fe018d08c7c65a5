#pragma once
#include "common/core/dense.hpp"

/// The small linear systems of corrected sums, M g = b: M is a sum of w x x^T with weights w >= 0, so it is
/// symmetric and its eigenvalues say how far the neighbours extend along each axis. Where one of them is
/// (nearly) zero the neighbours do not know the slope along that axis: one neighbour, neighbours on a line,
/// all in one place. All for d = 1, 2, 3.
namespace sph {

/// M^-1 b along those axes of a symmetric M whose eigenvalue is at least `least` > 0, and nothing along the
/// others.
// [guarded]
template <int d>
Vector<d> guarded_inverse_times(const Tensor<d>& M, const Vector<d>& b, double least) {
    if (extreme_eigenvalues<d>(M)[0] >= least) return inverse_times<d>(M, b);
    const Axes<d> axes = axes_of<d>(M);
    Vector<d> g{};
    for (std::size_t k = 0; k < d; ++k) {
        if (axes.value[k] >= least) g += (dot(axes.direction[k], b) / axes.value[k]) * axes.direction[k];
    }
    return g;
}
// [end]

/// The naive way. Divides by zero where the neighbours do not determine the slope, and amplifies what they do
/// not know where they nearly do not.
struct NaiveSolve {
    template <int d>
    Vector<d> operator()(const Tensor<d>& M, const Vector<d>& b, double) const {
        return inverse_times<d>(M, b);
    }
};

/// Returns no slope along an axis on which the neighbours extend less than a tenth of what they do where they
/// are everywhere (then the eigenvalues are `scale`). So with b = sum w D x and M = sum w x x^T the slope is
/// bounded, for any neighbours: |g| <= sqrt(d) max|D| sqrt(sum w / (least scale)).
struct GuardedSolve {
    static constexpr double least = 0.01;

    template <int d>
    Vector<d> operator()(const Tensor<d>& M, const Vector<d>& b, double scale) const {
        return guarded_inverse_times<d>(M, b, least * scale);
    }
};

}  // namespace sph
