#pragma once
#include <Eigen/LU>
#include <limits>

#include "chapters/06_finite_particle_method/bases.hpp"
#include "chapters/06_finite_particle_method/neighbourhood.hpp"

/// The family of this chapter. Multiply Taylor's series about particle i by a basis w_a, sum over neighbours:
///     sum_j V_j w_a(xi_j) f_j = sum_b M_ab phi_b,   M_ab = sum_j V_j w_a(xi_j) p_b(xi_j),
/// with the monomials p_b, xi_j = x_ji/h and phi_b = h^|b| times the derivative over its factorial   (Ye et
/// al. 2019, 12-14; Chen 2017, 95-104). The solution is linear in the f_j, so each particle gets a row of
/// coefficients for each derivative.
namespace sph {

/// What of the matrix is kept.
enum class Form {
    full,         ///< all: value and derivatives are solved for together
    keeps_value,  ///< f_i is the value, derivatives are fitted to the differences f_j - f_i
    triangular    ///< each order sees only lower ones: value by Shepard, slope, then curvature (CSPM)
};

/// A fit of order `order` in d dimensions.
template <class Basis, int d, int order, Form form>
class LocalFit final : public Estimator<d> {
    using Series = Taylor<d, order>;
    static constexpr auto n = static_cast<int>(Series::count);
    using Matrix = Eigen::Matrix<double, n, n>;
    using Functions = std::array<Tile, Series::count>;

  public:
    explicit LocalFit(bool with_volumes) : with_volumes_{with_volumes} {}
    bool needs_volumes() const override { return with_volumes_; }
    bool has_second() const override { return order >= 2; }

    double coefficients(const Neighbourhood<d>& near, const AnyKernel<d>& kernel,
                        Coefficients<d>& out) const override {
        const std::size_t tiles = near.tiles();
        if (basis_.size() < tiles) basis_.resize(tiles);
        const Matrix M = matrix(near, kernel);
        const Matrix inverse = M.inverse();
        solve(inverse, near, out);
        if constexpr (form != Form::full) subtract_own_value(near, out);
        const double condition = norm(M) * norm(inverse);
        return condition < std::numeric_limits<double>::infinity() ? condition
                                                                   : std::numeric_limits<double>::infinity();
    }

  private:
    /// The largest sum of absolute values in a column.
    static double norm(const Matrix& m) { return m.cwiseAbs().colwise().sum().maxCoeff(); }
    /// Whether the equation of w_a may see the unknown phi_b.
    static constexpr bool sees(std::size_t a, std::size_t b) {
        const auto& terms = Series::terms;
        if (form == Form::triangular && terms[b].degree > terms[a].degree) return false;
        return form == Form::full || (a == 0) == (b == 0);
    }

    // [matrix]
    Matrix matrix(const Neighbourhood<d>& near, const AnyKernel<d>& kernel) const {
        std::array<Functions, Series::count> sum{};
        for (std::size_t t = 0; t < near.tiles(); ++t) {
            const Vec<Tile, d> xi = (1 / near.h) * near.x_ji(t);
            const Functions p = Series::at(xi);
            Functions& w = basis_[t] = Basis::template at<order, d>(xi, kernel);
            const Tile V = near.V(t);
            for (Tile& one : w) one *= V;
            for (std::size_t a = 0; a < w.size(); ++a) {
                for (std::size_t b = 0; b < p.size(); ++b) sum[a][b] += w[a] * p[b];
            }
        }
        Matrix M = Matrix::Zero();
        for (int a = 0; a < n; ++a) {
            for (int b = 0; b < n; ++b) {
                const auto row = static_cast<std::size_t>(a), column = static_cast<std::size_t>(b);
                if (sees(row, column)) M(a, b) = sum[row][column].sum();
            }
        }
        return M;
    }
    // [end]

    /// out[k][j] = factorial/h^degree sum_a (M^-1)_ka w_a(xi_j)
    void solve(const Matrix& inverse, const Neighbourhood<d>& near, Coefficients<d>& out) const {
        constexpr std::size_t wanted = std::min(derivatives<d>, Series::count);
        for (std::size_t k = 0; k < wanted; ++k) {
            double scale = Series::terms[k].factorial;
            for (int power = 0; power < Series::terms[k].degree; ++power) scale /= near.h;
            std::array<double, Series::count> row;
            for (std::size_t a = 0; a < row.size(); ++a)
                row[a] = scale * inverse(static_cast<int>(k), static_cast<int>(a));
            for (std::size_t t = 0; t < near.tiles(); ++t) {
                Tile sum = row[0] * basis_[t][0];
                for (std::size_t a = 1; a < row.size(); ++a) sum += row[a] * basis_[t][a];
                sum.store(out.of(k) + t * tile_width);
            }
        }
    }

    /// sum_j c_j (f_j - f_i): what all others get, the particle itself loses. The value is then f_i itself,
    /// or Shepard's.
    void subtract_own_value(const Neighbourhood<d>& near, Coefficients<d>& out) const {
        if (near.self == Neighbourhood<d>::nobody) return;
        constexpr std::size_t wanted = std::min(derivatives<d>, Series::count);
        for (std::size_t k = 1; k < wanted; ++k) {
            double sum = 0;
            for (std::size_t j = 0; j < near.count; ++j) sum += out.of(k)[j];
            out.of(k)[near.self] -= sum;
        }
        if (form == Form::triangular) return;
        for (std::size_t j = 0; j < near.count; ++j) out.of(0)[j] = j == near.self ? 1 : 0;
    }

    bool with_volumes_;
    mutable std::vector<Functions> basis_;
};

}  // namespace sph
