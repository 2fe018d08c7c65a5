#pragma once
#include "chapters/02_consistency/corrected.hpp"

/// Across a jump there is no Taylor series. DSPH (M. B. Liu, G. R. Liu & Lam 2003, Shock Waves 13, 201)
/// splits the expansion at the jump: for neighbours on the other side it expands about x_k, the first
/// particle there, instead of x_i. In 1D, with the jump at a known place.
namespace sph {

/// Where the function jumps, and what it is on either side of it.
struct Jump {
    double at = 0;                   ///< position of the jump
    double x_left = 0, x_right = 0;  ///< the last particle before it and the first behind it
    double A_left = 0, A_right = 0;  ///< the function there

    /// The particles of a sorted or unsorted line nearest to the jump. Needs one on either side; throws
    /// std::invalid_argument otherwise.
    static Jump find(double at, const Column& x, const Column& A) {
        Jump jump{at, -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
        for (std::size_t i = 0; i < x.size(); ++i) {
            if (x[i] < at && x[i] > jump.x_left) {
                jump.x_left = x[i];
                jump.A_left = A[i];
            } else if (x[i] >= at && x[i] < jump.x_right) {
                jump.x_right = x[i];
                jump.A_right = A[i];
            }
        }
        if (!std::isfinite(jump.x_left) || !std::isfinite(jump.x_right))
            throw std::invalid_argument{"Jump: no particles on one side"};
        return jump;
    }
    double x_k(double x_i) const { return x_i < at ? x_right : x_left; }
    double A_k(double x_i) const { return x_i < at ? A_right : A_left; }
};

/// sum_(j beyond the jump) V_j W_ij, V_j F_ij x_ij, V_j A_j W_ij, V_j (A_j - A_i) F_ij x_ij and - V_j F_ij
/// x_ij^2: what the other side adds to the sums.
struct BeyondJump {
    static constexpr std::string_view name = "sums beyond the jump";
    template <class T, int>
    struct In {
        Vec<T, 5> beyond{};
    };
    Jump jump;
    using ReadsI = List<Position>;
    using Reads = List<Quantity>;
    using ReadsJ = List<Volume>;
    using Adds = List<BeyondJump>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const bool left = i.x[0] < jump.at;
        const Tile x_j = i.x[0] - pair.x_ij[0];
        // A particle at the jump belongs to the right.
        const Tile V = (left ? x_j >= jump.at : x_j < jump.at).select(j.V, 0.0);
        const Tile VFx = V * pair.F * pair.x_ij[0];
        sum.beyond[0] += V * pair.W;
        sum.beyond[1] += VFx;
        sum.beyond[2] += V * j.A * pair.W;
        sum.beyond[3] += (j.A - i.A) * VFx;
        sum.beyond[4] -= VFx * pair.x_ij[0];
    }
};

/// A_i = (sum_j V_j A_j W_ij - (A_k - A_i) sum_(beyond) V_j W_ij) / sum_j V_j W_ij
/// A_x,i = (sum_j V_j (A_j - A_i) W_x - (A_k - A_i) C) / (sum_j V_j (x_j - x_i) W_x - (x_k - x_i) C),
///     C = sum_(beyond) V_j W_x:
/// CSPM's value and slope (Chen 2017, 92, 94) without the jump, with one slope on both sides of it. Exact for
/// a line with a jump. To be listed with BeyondJump, whose sums it needs.
struct DiscontinuousFit {
    static constexpr std::string_view name = "value and slope beside a jump";
    template <class T, int>
    struct In {
        Vec<T, 2> dsph{};
    };
    Jump jump;
    using ReadsI = List<Position, Quantity>;
    using Uses = List<Value, ZerothMoment, DifferenceGradient, CorrectionMatrix>;
    using Writes = List<DiscontinuousFit>;
    void finish(const auto& i, const auto& sum, auto& out) const {
        const double A_ki = jump.A_k(i.x[0]) - i.A, x_ki = jump.x_k(i.x[0]) - i.x[0];
        out.dsph[0] = (sum.value - A_ki * sum.beyond[0]) / sum.m0;
        out.dsph[1] = (sum.gradient[0] - A_ki * sum.beyond[1]) / (sum.B[0][0] - x_ki * sum.beyond[1]);
    }
};

/// CSPM's value and slope from the neighbours on one's own side only. To be listed with BeyondJump.
struct OneSidedFit {
    static constexpr std::string_view name = "value and slope from one side of a jump";
    template <class T, int>
    struct In {
        Vec<T, 2> one_sided{};
    };
    using Uses = List<Value, ZerothMoment, DifferenceGradient, CorrectionMatrix>;
    using Writes = List<OneSidedFit>;
    void finish(const auto&, const auto& sum, auto& out) const {
        out.one_sided[0] = (sum.value - sum.beyond[2]) / (sum.m0 - sum.beyond[0]);
        out.one_sided[1] = (sum.gradient[0] - sum.beyond[3]) / (sum.B[0][0] - sum.beyond[4]);
    }
};

}  // namespace sph
