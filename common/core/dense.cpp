#include "common/core/dense.hpp"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <memory>
#include <stdexcept>
#include <string>

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
Vector<d> from_eigen(const Coordinates<d>& v) {
    Vector<d> result;
    for (int a = 0; a < d; ++a) result[static_cast<std::size_t>(a)] = v(a);
    return result;
}

/// GSL reports failures to the caller, instead of ending the program, for the length of a scope.
class Failures {
  public:
    Failures() : before_{gsl_set_error_handler_off()} {}
    Failures(const Failures&) = delete;
    Failures& operator=(const Failures&) = delete;
    ~Failures() { gsl_set_error_handler(before_); }
    static void require_done(int status, const char* what) {
        if (status != 0) throw std::runtime_error{std::string{what} + ": " + gsl_strerror(status)};
    }

  private:
    gsl_error_handler_t* before_;
};

}  // namespace

template <int d>
Vector<d> inverse_times(const Tensor<d>& M, const Vector<d>& b) {
    return from_eigen<d>(to_eigen<d>(M).inverse() * Eigen::Map<const Coordinates<d>>(b.begin()));
}

template <int d>
Axes<d> axes_of(const Tensor<d>& M) {
    if constexpr (d == 1) {
        return {{M[0][0]}, {{{1}}}};
    } else {
        const Eigen::SelfAdjointEigenSolver<Matrix<d>> solver{to_eigen<d>(M)};
        Axes<d> axes{from_eigen<d>(solver.eigenvalues())};
        for (int k = 0; k < d; ++k)
            axes.direction[static_cast<std::size_t>(k)] = from_eigen<d>(solver.eigenvectors().col(k));
        return axes;
    }
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
        const Axes<d> axes = axes_of<d>(M);
        return {axes.value[0], axes.value[d - 1]};
    }
}

template Vector<1> inverse_times<1>(const Tensor<1>&, const Vector<1>&);
template Vector<2> inverse_times<2>(const Tensor<2>&, const Vector<2>&);
template Vector<3> inverse_times<3>(const Tensor<3>&, const Vector<3>&);
template Axes<1> axes_of<1>(const Tensor<1>&);
template Axes<2> axes_of<2>(const Tensor<2>&);
template Axes<3> axes_of<3>(const Tensor<3>&);
template Vector<2> extreme_eigenvalues<1>(const Tensor<1>&);
template Vector<2> extreme_eigenvalues<2>(const Tensor<2>&);
template Vector<2> extreme_eigenvalues<3>(const Tensor<3>&);

Column solve(Dense M, const Column& b) {
    if (b.size() != M.size()) throw std::invalid_argument{"solve: as many values as rows"};
    if (b.empty()) return {};
    const Failures failures;
    const std::size_t n = M.size();
    gsl_matrix_view matrix = gsl_matrix_view_array(M.data(), n, n);
    const std::unique_ptr<gsl_permutation, void (*)(gsl_permutation*)> order{gsl_permutation_alloc(n),
                                                                             gsl_permutation_free};
    int sign = 0;
    failures.require_done(gsl_linalg_LU_decomp(&matrix.matrix, order.get(), &sign), "the LU decomposition");
    Column x(n);
    const gsl_vector_const_view right = gsl_vector_const_view_array(b.data(), n);
    gsl_vector_view solution = gsl_vector_view_array(x.data(), n);
    failures.require_done(gsl_linalg_LU_solve(&matrix.matrix, order.get(), &right.vector, &solution.vector),
                          "the linear system");
    return x;
}

std::vector<std::complex<double>> eigenvalues(Dense M) {
    const std::size_t n = M.size();
    if (n == 0) return {};
    const Failures failures;
    gsl_matrix_view matrix = gsl_matrix_view_array(M.data(), n, n);
    const std::unique_ptr<gsl_vector_complex, void (*)(gsl_vector_complex*)> values{
        gsl_vector_complex_alloc(n), gsl_vector_complex_free};
    const std::unique_ptr<gsl_eigen_nonsymm_workspace, void (*)(gsl_eigen_nonsymm_workspace*)> work{
        gsl_eigen_nonsymm_alloc(n), gsl_eigen_nonsymm_free};
    failures.require_done(gsl_eigen_nonsymm(&matrix.matrix, values.get(), work.get()), "the eigenvalues");
    std::vector<std::complex<double>> result;
    for (std::size_t k = 0; k < n; ++k) {
        const gsl_complex value = gsl_vector_complex_get(values.get(), k);
        result.emplace_back(GSL_REAL(value), GSL_IMAG(value));
    }
    return result;
}

}  // namespace sph
