#pragma once
#include "chapters/02_consistency/guarded_solve.hpp"
#include "chapters/04_artificial_viscosity/conduction.hpp"

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

/// S of the column Quantity, kept in the column Self; a vector has one row a component.
template <class Self, class Quantity>
struct SlopeOf {
    using Reads = List<Quantity>;
    using ReadsJ = List<Mass, Density>;
    using Adds = List<Self>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        constexpr int d = static_cast<int>(std::decay_t<decltype(pair.x_ij)>::size());
        const auto& f_i = member<Quantity, double, d>(i);
        const auto& f_j = member<Quantity, Tile, d>(j);
        const Tile weight = j.m / j.rho * F_i(pair);
        if constexpr (IsVec<std::decay_t<decltype(f_i)>>::value) {
            member<Self, Tile, d>(sum) -= outer(weight * (f_i - f_j), pair.x_ij);
        } else {
            member<Self, Tile, d>(sum) -= (weight * (f_i - f_j)) * pair.x_ij;
        }
    }
};
/// M^-1 S of the column Slope, kept in the column Self.
template <class Self, class Slope>
struct GradientFrom {
    using Uses = List<SlopeMatrix, Slope>;
    using Writes = List<Self>;
    void finish(const auto&, const auto& sum, auto& out) const {
        constexpr int d = static_cast<int>(sum.M.size());
        const auto& S = member<Slope, double, d>(sum);
        auto& gradient = member<Self, double, d>(out);
        if constexpr (std::is_same_v<std::decay_t<decltype(S)>, Vector<d>>) {
            gradient = GuardedSolve{}(sum.M, S, 1.0);
        } else {
            for (std::size_t a = 0; a < d; ++a) gradient[a] = GuardedSolve{}(sum.M, S[a], 1.0);
        }
    }
};

struct VelocitySlope : SlopeOf<VelocitySlope, MiddleVelocity> {
    static constexpr std::string_view name = "sum for the gradient of velocity";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> S_v{};
    };
};
/// (grad v)_ab = dv_a/dx_b of the velocity in the middle of the step   [1/time].
struct VelocityGradient : GradientFrom<VelocityGradient, VelocitySlope> {
    static constexpr std::string_view name = "gradient of velocity";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> dv_dx{};
    };
};

struct EnergySlope : SlopeOf<EnergySlope, ThermalEnergy> {
    static constexpr std::string_view name = "sum for the gradient of thermal energy";
    template <class T, int d>
    struct In {
        Vec<T, d> S_u{};
    };
};
/// grad u   [energy by mass/length].
struct EnergyGradient : GradientFrom<EnergyGradient, EnergySlope> {
    static constexpr std::string_view name = "gradient of thermal energy";
    template <class T, int d>
    struct In {
        Vec<T, d> du_dx{};
    };
};

struct PressureSlope : SlopeOf<PressureSlope, Pressure> {
    static constexpr std::string_view name = "sum for the gradient of pressure";
    template <class T, int d>
    struct In {
        Vec<T, d> S_p{};
    };
};
/// grad P   [pressure/length].
struct PressureGradient : GradientFrom<PressureGradient, PressureSlope> {
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
