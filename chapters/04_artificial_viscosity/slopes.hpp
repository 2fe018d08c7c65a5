#pragma once
#include "chapters/04_artificial_viscosity/conduction.hpp"

/// Gradients that are exact for linear functions, for detectors of shocks and for reconstruction: grad f = S
/// M^-1 with the sums over j of V F (f_i - f_j) x_ij^T (S) and of V F x_ij x_ij^T (M), V = m/rho: chapter 2's
/// corrected gradient with the weight -F.
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
        sum.M += outer((j.m / j.rho * F_i(pair)) * pair.x_ij, pair.x_ij);
    }
};

namespace slopes_detail {
template <int d>
Vector<d> column(const Vec<Vector<d>, d>& M, std::size_t b) {
    Vector<d> c;
    for (std::size_t a = 0; a < d; ++a) c[a] = M[a][b];
    return c;
}
/// x of M x = s for symmetric M of one or two rows; 0 where the neighbours do not span the space.
inline Vector<1> solve(const Vec<Vector<1>, 1>& M, const Vector<1>& s) {
    return {M[0][0] != 0 ? s[0] / M[0][0] : 0};
}
inline Vector<2> solve(const Vec<Vector<2>, 2>& M, const Vector<2>& s) {
    const double det = M[0][0] * M[1][1] - M[0][1] * M[1][0], trace = M[0][0] + M[1][1];
    if (!(det > 1e-12 * trace * trace)) return {};
    return {(s[0] * M[1][1] - s[1] * M[0][1]) / det, (s[1] * M[0][0] - s[0] * M[1][0]) / det};
}
}  // namespace slopes_detail

/// (grad v)_ab = dv_a/dx_b of the velocity in the middle of the step   [1/time].
struct VelocitySlope {
    static constexpr std::string_view name = "sum for the gradient of velocity";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> S_v{};
    };
    using Reads = List<MiddleVelocity>;
    using ReadsJ = List<Mass, Density>;
    using Adds = List<VelocitySlope>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.S_v += outer((j.m / j.rho * F_i(pair)) * (i.v_mid - j.v_mid), pair.x_ij);
    }
};
struct VelocityGradient {
    static constexpr std::string_view name = "gradient of velocity";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> dv_dx{};
    };
    using Uses = List<SlopeMatrix, VelocitySlope>;
    using Writes = List<VelocityGradient>;
    void finish(const auto&, const auto& sum, auto& out) const {
        for (std::size_t a = 0; a < sum.S_v.size(); ++a)
            out.dv_dx[a] = slopes_detail::solve(sum.M, sum.S_v[a]);
    }
};

/// grad u   [energy by mass/length].
struct EnergySlope {
    static constexpr std::string_view name = "sum for the gradient of thermal energy";
    template <class T, int d>
    struct In {
        Vec<T, d> S_u{};
    };
    using Reads = List<ThermalEnergy>;
    using ReadsJ = List<Mass, Density>;
    using Adds = List<EnergySlope>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.S_u += (j.m / j.rho * F_i(pair) * (i.u - j.u)) * pair.x_ij;
    }
};
struct EnergyGradient {
    static constexpr std::string_view name = "gradient of thermal energy";
    template <class T, int d>
    struct In {
        Vec<T, d> du_dx{};
    };
    using Uses = List<SlopeMatrix, EnergySlope>;
    using Writes = List<EnergyGradient>;
    void finish(const auto&, const auto& sum, auto& out) const {
        out.du_dx = slopes_detail::solve(sum.M, sum.S_u);
    }
};

/// grad P   [pressure/length].
struct PressureSlope {
    static constexpr std::string_view name = "sum for the gradient of pressure";
    template <class T, int d>
    struct In {
        Vec<T, d> S_p{};
    };
    using Reads = List<Pressure>;
    using ReadsJ = List<Mass, Density>;
    using Adds = List<PressureSlope>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.S_p += (j.m / j.rho * F_i(pair) * (i.p - j.p)) * pair.x_ij;
    }
};
struct PressureGradient {
    static constexpr std::string_view name = "gradient of pressure";
    template <class T, int d>
    struct In {
        Vec<T, d> dp_dx{};
    };
    using Uses = List<SlopeMatrix, PressureSlope>;
    using Writes = List<PressureGradient>;
    void finish(const auto&, const auto& sum, auto& out) const {
        out.dp_dx = slopes_detail::solve(sum.M, sum.S_p);
    }
};

template <class T, int d>
T divergence(const Vec<Vec<T, d>, d>& gradient) {
    T sum = gradient[0][0];
    for (std::size_t a = 1; a < gradient.size(); ++a) sum += gradient[a][a];
    return sum;
}

}  // namespace sph
