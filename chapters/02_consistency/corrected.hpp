#pragma once
#include "chapters/02_consistency/guarded_solve.hpp"
#include "chapters/02_consistency/moments.hpp"

/// Corrected sums: each divides by what it finds instead of by what it should find.
///
/// The slopes here are all one idea, a straight line fitted through (x_i, A_i) by weighted least squares:
/// with M = sum_j w_j x_ij x_ij^T and b = - sum_j w_j (A_j - A_i) x_ij the slope is M^-1 b, exact for a
/// linear A whatever the neighbours. They differ in the weight w: - V F for CSPM and for Bonet and Lok's
/// matrix, which are the same thing, and V W for the linearly exact gradient.
namespace sph {

// [shepard]
/// A_i = sum_j V_j A_j W_ij / sum_j V_j W_ij   (Shepard; CSPM: Chen 2017, 92; Ye et al. 2019, 10). Exact for
/// constants.
struct Shepard {
    static constexpr std::string_view name = "Shepard's value";
    template <class T, int>
    struct In {
        T shepard{};
    };
    using Uses = List<Value, ZerothMoment>;
    using Writes = List<Shepard>;
    void finish(const auto&, const auto& sum, auto& out) const { out.shepard = sum.value / sum.m0; }
};
// [end]

/// B_i = - sum_j V_j F_ij x_ij x_ij^T: the inverse of Bonet and Lok's (1999) matrix L; the unit matrix in the
/// limit.
struct CorrectionMatrix {
    static constexpr std::string_view name = "correction matrix";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> B{};
    };
    using ReadsJ = List<Volume>;
    using Adds = List<CorrectionMatrix>;
    void add(const auto&, const auto& j, const auto& pair, auto& sum) const {
        sum.B -= outer((j.V * pair.F) * pair.x_ij, pair.x_ij);
    }
};

// [matrix]
/// grad A_i = B_i^-1 sum_j V_j (A_j - A_i) grad_i W_ij: the gradient of differences (Monaghan 2005, 2.14),
/// corrected. In 1D CSPM's quotient (Chen 2017, 94; Ye et al. 2019, 11); in d dimensions Bonet and Lok's
/// corrected gradient.
template <class Solve = GuardedSolve>
struct MatrixGradient {
    static constexpr std::string_view name = "gradient corrected by a matrix";
    template <class T, int d>
    struct In {
        Vec<T, d> matrix{};
    };
    using Uses = List<DifferenceGradient, CorrectionMatrix>;
    using Writes = List<MatrixGradient>;
    void finish(const auto&, const auto& sum, auto& out) const {
        out.matrix = Solve{}(sum.B, sum.gradient, 1.0);
    }
};
// [end]

/// CSPM's quotient (94) taken axis by axis in d dimensions: what one writes when one reads (94) component by
/// component. Not exact for linear functions unless B is diagonal.
struct AxisGradient {
    static constexpr std::string_view name = "gradient corrected axis by axis";
    template <class T, int d>
    struct In {
        Vec<T, d> axis{};
    };
    using Uses = List<DifferenceGradient, CorrectionMatrix>;
    using Writes = List<AxisGradient>;
    void finish(const auto&, const auto& sum, auto& out) const {
        for (std::size_t a = 0; a < out.axis.size(); ++a) out.axis[a] = sum.gradient[a] / sum.B[a][a];
    }
};

/// - sum_j V_j W_ij (A_j - A_i) x_ij: the right-hand side of the linearly exact gradient.
struct WeightedDifferences {
    static constexpr std::string_view name = "weighted differences";
    template <class T, int d>
    struct In {
        Vec<T, d> differences{};
    };
    using Reads = List<Quantity>;
    using ReadsJ = List<Volume>;
    using Adds = List<WeightedDifferences>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.differences -= (j.V * (j.A - i.A) * pair.W) * pair.x_ij;
    }
};

/// grad A_i = (sum_j V_j W_ij x_ij x_ij^T)^-1 sum_j V_j W_ij (A_i - A_j) x_ij: least squares with weight V W.
/// Needs no derivative of the kernel.
template <class Solve = GuardedSolve>
struct LinearGradient {
    static constexpr std::string_view name = "linearly exact gradient";
    template <class T, int d>
    struct In {
        Vec<T, d> linear{};
    };
    using Uses = List<SecondMoment, WeightedDifferences>;
    using Writes = List<LinearGradient>;
    double h = 1;  ///< the scale of the second moments is h^2
    void finish(const auto&, const auto& sum, auto& out) const {
        out.linear = Solve{}(sum.m2, sum.differences, h * h);
    }
};

/// sum_j V_j W_ij A_j x_ij
struct FirstOfQuantity {
    static constexpr std::string_view name = "first moment of the quantity";
    template <class T, int d>
    struct In {
        Vec<T, d> a1{};
    };
    using ReadsJ = List<Volume, Quantity>;
    using Adds = List<FirstOfQuantity>;
    void add(const auto&, const auto& j, const auto& pair, auto& sum) const {
        sum.a1 += (j.V * j.A * pair.W) * pair.x_ij;
    }
};

/// m2 - m0 c c^T with c = m1/m0, the neighbours' mean offset: their spread about their centre.
auto spread_about_centre(const auto& sum) {
    auto spread = sum.m2;
    spread -= outer((1 / sum.m0) * sum.m1, sum.m1);
    return spread;
}

/// Keeps the second term of (Chen 2017, 90): the line fitted to the neighbours by least squares with weight V
/// W, which need not pass through A_i. With c = m1/m0 the neighbours' mean offset:
///     slope = (m2 - m0 c c^T)^-1 (A_0 c - a1),   value = A_0/m0 + slope . c,   A_0 = sum_j V_j A_j W_ij.
/// Exact for linear functions, value and slope, and defined at any position.
template <class Solve = GuardedSolve>
struct LinearFit {
    static constexpr std::string_view name = "value and slope of a fitted line";
    /// The value, and behind it the slope.
    template <class T, int d>
    struct In {
        Vec<T, d + 1> fit{};
    };
    using Uses = List<Value, ZerothMoment, FirstMoment, SecondMoment, FirstOfQuantity>;
    using Writes = List<LinearFit>;
    double h = 1;
    void finish(const auto&, const auto& sum, auto& out) const {
        const auto c = (1 / sum.m0) * sum.m1;
        const auto slope = Solve{}(spread_about_centre(sum), sum.value * c - sum.a1, h * h);
        out.fit[0] = sum.value / sum.m0 + dot(slope, c);
        for (std::size_t a = 0; a < slope.size(); ++a) out.fit[a + 1] = slope[a];
    }
};

/// The smallest and the largest eigenvalue of (m2 - m0 c c^T)/h^2, c = m1/m0: how far the neighbours extend
/// about their centre, along the axis on which they extend least and most. What no line can be fitted to
/// shows here, whatever the scheme.
struct Extent {
    static constexpr std::string_view name = "extent of the neighbours";
    template <class T, int>
    struct In {
        Vec<T, 2> extent{};
    };
    using Uses = List<ZerothMoment, FirstMoment, SecondMoment>;
    using Writes = List<Extent>;
    double h = 1;
    void finish(const auto&, const auto& sum, auto& out) const {
        out.extent = (1 / (h * h)) *
                     extreme_eigenvalues<std::decay_t<decltype(sum)>::dimension>(spread_about_centre(sum));
    }
};

/// d2A_i/dx2 in 1D: (sum_j V_j (A_j - A_i) W'' - A_x sum_j V_j (x_j - x_i) W'') / (1/2 sum_j V_j (x_j -
/// x_i)^2 W'') with A_x from (94)   (CSPM: Ye et al. 2019, 11, where W' stands for W'' in the denominator:
/// that is zero on a symmetric lattice).
struct CspmCurvature {
    static constexpr std::string_view name = "CSPM's second derivative";
    template <class T, int>
    struct In {
        T curvature{};
    };
    struct Sums {
        static constexpr std::string_view name = "sums with the kernel's second derivative";
        template <class T, int>
        struct In {
            Vec<T, 3> with_d2W{};
        };
        using Reads = List<Quantity>;
        using ReadsJ = List<Volume>;
        using Adds = List<Sums>;
        void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
            const Tile weight = j.V * pair.d2W, x_ji = -pair.x_ij[0];
            sum.with_d2W[0] += weight * (j.A - i.A);
            sum.with_d2W[1] += weight * x_ji;
            sum.with_d2W[2] += weight * x_ji.square();
        }
    };
    using Uses = List<DifferenceGradient, CorrectionMatrix, Sums>;
    using Writes = List<CspmCurvature>;
    void finish(const auto&, const auto& sum, auto& out) const {
        const double slope = GuardedSolve{}(sum.B, sum.gradient, 1.0)[0];
        out.curvature = (sum.with_d2W[0] - slope * sum.with_d2W[1]) / (0.5 * sum.with_d2W[2]);
    }
};

}  // namespace sph
