#pragma once
#include <complex>
#include <vector>

#include "common/core/vec.hpp"

/// Dense linear algebra, by Eigen and GSL: compiled in one file, since their headers cost seconds.
namespace sph {

// Small systems, one for each particle. d = 1, 2, 3.
template <int d>
using Tensor = Vec<Vec<double, d>, d>;

/// M^-1 b by Cramer's rule, whatever M is.
template <int d>
Vector<d> inverse_times(const Tensor<d>& M, const Vector<d>& b);

/// The eigenvalues of a symmetric tensor, the smallest first, and the unit vectors along its axes.
template <int d>
struct Axes {
    Vector<d> value{};
    Vec<Vector<d>, d> direction{};
};
template <int d>
Axes<d> axes_of(const Tensor<d>& M);
/// The smallest and the largest eigenvalue of a symmetric tensor. In one and two dimensions a formula.
template <int d>
Vector<2> extreme_eigenvalues(const Tensor<d>& M);

/// A square matrix with some hundred rows, one for each particle.
class Dense {
  public:
    explicit Dense(std::size_t n) : n_{n}, entries_(n * n) {}
    std::size_t size() const noexcept { return n_; }
    double& operator()(std::size_t row, std::size_t column) { return entries_[row * n_ + column]; }
    double operator()(std::size_t row, std::size_t column) const { return entries_[row * n_ + column]; }
    double* data() noexcept { return entries_.data(); }

  private:
    std::size_t n_;
    Column entries_;
};
/// x of M x = b, by LU decomposition with pivots. Throws std::runtime_error for a singular M. Cost: n^3/3
/// products.
Column solve(Dense M, const Column& b);
/// All eigenvalues of any M. Cost: some 10 n^3 operations.
std::vector<std::complex<double>> eigenvalues(Dense M);

}  // namespace sph
