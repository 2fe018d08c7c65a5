#include "chapters/02_consistency/guarded_solve.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace sph {
namespace {

template <int d>
using Matrix = Eigen::Matrix<double, d, d>;
template <int d>
using Coordinates = Eigen::Matrix<double, d, 1>;

template <int d>
Matrix<d> to_eigen(const Tensor<d>& rows) {
    Matrix<d> m;
    for (int a = 0; a < d; ++a) {
        for (int b = 0; b < d; ++b) m(a, b) = rows[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
    }
    return m;
}
template <int d>
Coordinates<d> to_eigen(const Vector<d>& v) {
    return Eigen::Map<const Coordinates<d>>(v.begin());
}
template <int d>
Vector<d> from_eigen(const Coordinates<d>& v) {
    Vector<d> result;
    for (int a = 0; a < d; ++a) result[static_cast<std::size_t>(a)] = v(a);
    return result;
}

}  // namespace

template <int d>
Vector<d> inverse_times(const Tensor<d>& M, const Vector<d>& b) {
    return from_eigen<d>(to_eigen<d>(M).inverse() * to_eigen<d>(b));
}

template <int d>
Vector<2> extreme_eigenvalues(const Tensor<d>& M) {
    if constexpr (d == 1) {
        return {M[0][0], M[0][0]};
    } else if constexpr (d == 2) {
        const double mean = 0.5 * (M[0][0] + M[1][1]);
        const double spread = std::hypot(0.5 * (M[0][0] - M[1][1]), M[0][1]);
        return {mean - spread, mean + spread};
    } else {
        const Eigen::SelfAdjointEigenSolver<Matrix<d>> axes{to_eigen<d>(M), Eigen::EigenvaluesOnly};
        return {axes.eigenvalues()(0), axes.eigenvalues()(d - 1)};
    }
}

template <int d>
Vector<d> guarded_inverse_times(const Tensor<d>& M, const Vector<d>& b, double least) {
    if (extreme_eigenvalues<d>(M)[0] >= least) return inverse_times<d>(M, b);
    const Eigen::SelfAdjointEigenSolver<Matrix<d>> axes{to_eigen<d>(M)};
    Coordinates<d> g = Coordinates<d>::Zero();
    for (int k = 0; k < d; ++k) {
        const double value = axes.eigenvalues()(k);
        if (value >= least)
            g += axes.eigenvectors().col(k) * (axes.eigenvectors().col(k).dot(to_eigen<d>(b)) / value);
    }
    return from_eigen<d>(g);
}

template Vector<1> inverse_times<1>(const Tensor<1>&, const Vector<1>&);
template Vector<2> inverse_times<2>(const Tensor<2>&, const Vector<2>&);
template Vector<3> inverse_times<3>(const Tensor<3>&, const Vector<3>&);
template Vector<2> extreme_eigenvalues<1>(const Tensor<1>&);
template Vector<2> extreme_eigenvalues<2>(const Tensor<2>&);
template Vector<2> extreme_eigenvalues<3>(const Tensor<3>&);
template Vector<1> guarded_inverse_times<1>(const Tensor<1>&, const Vector<1>&, double);
template Vector<2> guarded_inverse_times<2>(const Tensor<2>&, const Vector<2>&, double);
template Vector<3> guarded_inverse_times<3>(const Tensor<3>&, const Vector<3>&, double);

}  // namespace sph
