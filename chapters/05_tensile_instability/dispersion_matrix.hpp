#pragma once
#include <complex>

#include "chapters/05_tensile_instability/lattice.hpp"

/// Small motions of a stressed lattice of particles: its dispersion matrix, exact for any kernel, h, stress
/// and wave vector. Units: the spacing, the speed of sound and a particle's mass are 1.
namespace sph {

/// Minus the stress, -sigma: the same pressure P in all directions.
template <int d>
Tensor<d> isotropic(double P) {
    Tensor<d> pressure;
    for (std::size_t a = 0; a < d; ++a) pressure[a][a] = P;
    return pressure;
}

/// Displacements u(x, t) = xi exp(i k . x - i omega t) of the lattice obey omega^2 xi = M(k) xi, where for
///     dv_i/dt = - sum_j m_j (Pi_i/rho_i^2 + Pi_j/rho_j^2) grad_i W_ij,   Pi = pressure + c^2 (rho - rho_0)
///     1,
/// and rho by summation
///     M = A' s s^T + 2 A T,   A = Pi/rho^2,   A' = dA/drho = 1/rho^2 - 2 Pi/rho^3,
///     s = sum_r sin(k . r) grad W(r),   T = sum_r (1 - cos k . r) grad grad W(r).
/// Derived in the chapter's text. `pressure` is the tensor Pi on the lattice [m c^2/dx^d], any, also
/// anisotropic: then M is not symmetric. k [1/dx]. Cost: one sine and cosine for each neighbour.
// [matrix]
template <int d>
Tensor<d> dispersion_matrix(const LatticeKernel<d>& lattice, const Tensor<d>& pressure, const Vector<d>& k) {
    Vector<d> s;
    Tensor<d> T;
    for (const auto& neighbour : lattice.half) {  // the one at -r adds the same
        const double phase = dot(k, neighbour.x);
        s += 2 * std::sin(phase) * neighbour.gradient;
        T += 2 * (1 - std::cos(phase)) * neighbour.hessian;
    }
    const double rho = lattice.density;
    const Tensor<d> A = (1 / (rho * rho)) * pressure;
    const Tensor<d> A_slope = (1 / (rho * rho)) * isotropic<d>(1) - (2 / (rho * rho * rho)) * pressure;
    Tensor<d> M;
    for (std::size_t a = 0; a < d; ++a) {
        M[a] = dot(A_slope[a], s) * s;
        for (std::size_t b = 0; b < d; ++b) M[a] += 2 * A[a][b] * T[b];
    }
    return M;
}
// [end]

/// The eigenvalues omega^2 of M, the one with the smaller real part first. d = 1, 2.
template <int d>
Vec<std::complex<double>, d> squared_frequencies(const Tensor<d>& M) {
    if constexpr (d == 1) {
        return {M[0][0]};
    } else {
        const double mean = (M[0][0] + M[1][1]) / 2, half = (M[0][0] - M[1][1]) / 2;
        const auto root = std::sqrt(std::complex<double>{half * half + M[0][1] * M[1][0]});
        return {mean - root, mean + root};
    }
}

/// The rate at which the fastest of the lattice's motions at k grows, max Re sqrt(-omega^2) [c/dx]; 0 if all
/// of them are waves. What rounding alone can make of the sums counts as 0.
template <int d>
double growth(const LatticeKernel<d>& lattice, const Tensor<d>& pressure, const Vector<d>& k) {
    double fastest = 0, scale = 0;
    for (const auto& omega2 : squared_frequencies<d>(dispersion_matrix(lattice, pressure, k)))
        fastest = std::max(fastest, std::sqrt(-omega2).real());
    for (const auto& neighbour : lattice.half) {
        for (const auto& row : neighbour.hessian) scale = std::max(scale, std::abs(row[0]));
    }
    return square(fastest) > 1e-13 * std::max(scale, 1.0) ? fastest : 0;
}

}  // namespace sph
