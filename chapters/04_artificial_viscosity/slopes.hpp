#pragma once
#include "chapters/02_consistency/guarded_solve.hpp"
#include "chapters/03_euler_sph/resolution.hpp"
#include "chapters/04_artificial_viscosity/dissipation.hpp"

/// Gradients that are exact for linear functions, for detectors of shocks and for reconstruction: chapter 2's
/// corrected gradient (corrected.hpp), with V = m/rho and each particle's own h,
///     grad f_i = M^-1 S,   M = - sum_j V_j F_ij x_ij x_ij^T,   S = - sum_j V_j F_ij (f_i - f_j) x_ij^T.
/// M is near the unit tensor; along an axis that the neighbours do not span there is no slope (GuardedSolve).
namespace sph {

struct SlopeMatrix {
    static constexpr std::string_view name = "matrix of the linear fit";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> M{};
    };
    using ReadsJ = List<Mass, Density>;
    using Adds = List<SlopeMatrix>;
    void add(const auto&, const auto& j, const auto& pair, auto& sum) const {
        sum.M -= outer((j.m / j.rho * F_i(pair)) * pair.x_ij, pair.x_ij);
    }
};

/// S of the column Quantity; a vector has one row a component.
template <class Quantity>
struct SlopeSum {
    static constexpr std::string_view name = "sum for a gradient";
    template <class T, int d>
    static auto& value(auto& row) {
        return member<Quantity, T, d>(row);
    }
    template <class T, int d>
    struct In {
        using Value =
            std::decay_t<decltype(value<T, d>(std::declval<typename Quantity::template In<T, d>&>()))>;
        std::conditional_t<IsVec<Value>::value, Vec<Vec<T, d>, d>, Vec<T, d>> S{};
    };
    using Reads = List<Quantity>;
    using ReadsJ = List<Mass, Density>;
    using Adds = List<SlopeSum>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        constexpr int d = static_cast<int>(std::decay_t<decltype(pair.x_ij)>::size());
        const auto change = value<double, d>(i) - value<Tile, d>(j);
        const Tile weight = j.m / j.rho * F_i(pair);
        auto& S = member<SlopeSum, Tile, d>(sum);
        if constexpr (IsVec<std::decay_t<decltype(change)>>::value) {
            S -= outer(weight * change, pair.x_ij);
        } else {
            S -= (weight * change) * pair.x_ij;
        }
    }
};

/// M^-1 S of the column Quantity, kept in the column Self. Of: what the particles of a fluid count (OfMass).
template <class Self, class Quantity, class Of = OfMass>
struct GradientOf {
    using Uses =
        List<typename Of::template Counted<SlopeMatrix>, typename Of::template Counted<SlopeSum<Quantity>>>;
    using Writes = List<Self>;
    template <class Sum>
    void finish(const auto&, const Sum& sum, auto& out) const {
        constexpr int d = static_cast<int>(decltype(Sum::M)::size());
        const auto& S = member<SlopeSum<Quantity>, double, d>(sum);
        auto& gradient = member<Self, double, d>(out);
        if constexpr (std::is_same_v<std::decay_t<decltype(S)>, Vector<d>>) {
            gradient = GuardedSolve{}(sum.M, S, 1.0);
        } else {
            for (std::size_t a = 0; a < d; ++a) gradient[a] = GuardedSolve{}(sum.M, S[a], 1.0);
        }
    }
};

/// (grad v)_ab = dv_a/dx_b of the velocity in the middle of the step   [1/time].
struct VelocityGradient : GradientOf<VelocityGradient, MiddleVelocity> {
    static constexpr std::string_view name = "gradient of velocity";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> dv_dx{};
    };
};
/// grad u   [energy by mass/length].
struct EnergyGradient : GradientOf<EnergyGradient, ThermalEnergy> {
    static constexpr std::string_view name = "gradient of thermal energy";
    template <class T, int d>
    struct In {
        Vec<T, d> du_dx{};
    };
};
/// grad P   [pressure/length].
struct PressureGradient : GradientOf<PressureGradient, Pressure> {
    static constexpr std::string_view name = "gradient of pressure";
    template <class T, int d>
    struct In {
        Vec<T, d> dp_dx{};
    };
};

template <class T, int d>
T divergence(const Vec<Vec<T, d>, d>& gradient) {
    T sum = gradient[0][0];
    for (std::size_t a = 1; a < gradient.size(); ++a) sum += gradient[a][a];
    return sum;
}

}  // namespace sph
