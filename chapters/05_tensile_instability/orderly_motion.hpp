#pragma once
#include "chapters/02_consistency/moments.hpp"

/// Cures of the tensile instability that move particles with another velocity than theirs, and what a fluid
/// needs that remembers where its particles began.
namespace sph {

/// dx/dt, where it is not v.
struct TransportVelocity {
    static constexpr std::string_view name = "transport velocity";
    template <class T, int d>
    struct In {
        Vec<T, d> dx_dt{};
    };
};
/// dx_i/dt = v_i - epsilon sum_j 2 m_j/(rho_i + rho_j) v_ij W_ij   (Monaghan 2005, 5.61 with Monaghan 1989):
/// XSPH, which moves a particle with the mean of its neighbours. 0 <= epsilon <= 1
struct XsphVelocity {
    double epsilon = 0.5;
    using Reads = List<Velocity, Density>;
    using ReadsJ = List<Mass>;
    using Adds = List<TransportVelocity>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.dx_dt -= (2 * epsilon * j.m / (i.rho + j.rho) * pair.W) * (i.v - j.v);
    }
    void finish(const auto& i, const auto&, auto& out) const { out.dx_dt += i.v; }
};

/// dv_i/dt = sum_j m_j (A_i/rho_i^2 + A_j/rho_j^2) grad_i W_ij, A = rho v (dx/dt - v)^T   (Adami, Hu & Adams
/// 2013): the momentum that particles carry with them where they do not move with v.
struct TransportStress {
    using Reads = List<Velocity, TransportVelocity, Density>;
    using ReadsJ = List<Mass>;
    using Adds = List<Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const Tile across_i = dot(i.dx_dt - i.v, pair.x_ij), across_j = dot(j.dx_dt - j.v, pair.x_ij);
        sum.dv_dt += (j.m * pair.F * across_i / i.rho) * i.v + (j.m * pair.F * across_j / j.rho) * j.v;
    }
};

/// g_i = sum_j V_j (1 + R (W_ij/W(dx))^4) grad_i W_ij: 0 in order, and away from where particles are too few.
/// R = 0.2 keeps pairs apart (Lind et al. 2012), R = 0 is the gradient of a constant.
struct DisorderGradient {
    static constexpr std::string_view name = "gradient of the disorder";
    template <class T, int d>
    struct In {
        Vec<T, d> disorder{};
    };
    double R = 0, W_spacing = 1;  ///< >= 0; W at the spacing of the lattice, > 0
    using ReadsJ = List<Volume>;
    using Adds = List<DisorderGradient>;
    void add(const auto&, const auto& j, const auto& pair, auto& sum) const {
        const Tile near = square(square(pair.W / W_spacing));
        sum.disorder += (j.V * (1 + R * near) * pair.F) * pair.x_ij;
    }
};

/// u = x - X: how far a particle is from where it began.
struct Displacement {
    static constexpr std::string_view name = "displacement";
    template <class T, int d>
    struct In {
        Vec<T, d> u{};
    };
};
/// G_i = sum_j V_j (u_j - u_i) grad_i W_ij^T over the neighbours of the beginning; with the inverse of the
/// CorrectionMatrix, F = 1 + G K is the gradient of the deformation   (Bonet & Kulasegaram 2001).
struct DisplacementGradient {
    static constexpr std::string_view name = "gradient of the displacement";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> G{};
    };
    using Reads = List<Displacement>;
    using ReadsJ = List<Volume>;
    using Adds = List<DisplacementGradient>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.G += outer((j.V * pair.F) * (j.u - i.u), pair.x_ij);
    }
};
/// S_i, a tensor of pressure that belongs to the beginning: P J F^-T K.
struct ReferenceStress {
    static constexpr std::string_view name = "stress in the reference configuration";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> S{};
    };
};
/// dv_i/dt = - V_i/m_i sum_j V_j (S_i + S_j) grad_i W_ij over the neighbours of the beginning: total
/// Lagrangian SPH (Bonet & Kulasegaram 2001). The neighbours never change, so nothing can clump, and nothing
/// can flow. V: the volumes of the beginning.
struct ReferenceForce {
    using Reads = List<ReferenceStress, Volume>;
    using ReadsI = List<Mass>;
    using Adds = List<Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const Tile weight = (i.V / i.m) * j.V * pair.F;
        for (std::size_t a = 0; a < pair.x_ij.size(); ++a) {
            for (std::size_t b = 0; b < pair.x_ij.size(); ++b)
                sum.dv_dt[a] -= weight * (i.S[a][b] + j.S[a][b]) * pair.x_ij[b];
        }
    }
};

}  // namespace sph
