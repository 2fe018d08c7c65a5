#pragma once
#include "chapters/05_tensile_instability/elasticity.hpp"

/// Total Lagrangian solids: all sums go over the neighbours that a particle had at the beginning, at their
/// places X of then. Kernels never see the deformation, so tension cannot make particles clump.
namespace sph {

/// x - X, where a particle is relative to where it began.
struct Displacement {
    static constexpr std::string_view name = "displacement";
    template <class T, int d>
    struct In {
        Vec<T, d> moved{};
    };
};

// [deformation]
/// H_i = sum_j V_j (u_j - u_i) grad_i W(X_ij), u = x - X. The deformation gradient is F = dx/dX = 1 + H B^-1
/// with chapter 2's matrix B of the beginning: exact for every linear motion.
struct DisplacementGradient {
    static constexpr std::string_view name = "gradient of the displacement";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> H{};
    };
    using Reads = List<Displacement>;
    using ReadsJ = List<Volume>;
    using Adds = List<DisplacementGradient>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.H -= outer((j.V * pair.F) * (i.moved - j.moved), pair.x_ij);
    }
};
// [end]

/// P B^-1, the first Piola-Kirchhoff stress P as the force sums it   [pressure].
struct ReferenceStress {
    static constexpr std::string_view name = "stress on the places of the beginning";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> PB{};
    };
};
/// Energy of a particle's deformation.
struct ElasticEnergy {
    static constexpr std::string_view name = "elastic energy";
    template <class T, int>
    struct In {
        T elastic{};
    };
};

// [neo-hookean]
/// Neo-Hookean energy per volume, Psi = mu/2 (F:F - 2 - 2 ln J) + lambda/2 (ln J)^2, J = det F, in plane
/// strain, and P = dPsi/dF = mu (F - F^-T) + lambda ln J F^-T. A rotation F -> Q F leaves Psi as it is, so
/// P F^T is symmetric. For small strains it is Hooke's law. A particle that is turned inside out (J <= 0) has
/// an energy that is no number.
struct NeoHookean {
    Elastic matter;
    using Uses = List<DisplacementGradient>;
    using ReadsI = List<Volume, CorrectionMatrix>;
    using Writes = List<ReferenceStress, ElasticEnergy>;
    void finish(const auto& i, const auto& sum, auto& out) const {
        Tensor<2> F = sum.H;
        for (std::size_t a = 0; a < 2; ++a) {
            F[a] = inverse_times<2>(i.B, F[a]);
            F[a][a] += 1;
        }
        const double J = F[0][0] * F[1][1] - F[0][1] * F[1][0], log_J = std::log(J);
        const Tensor<2> J_inverse_transposed{{{F[1][1], -F[1][0]}, {-F[0][1], F[0][0]}}};
        const double share = (matter.lame() * log_J - matter.shear) / J;
        for (std::size_t a = 0; a < 2; ++a) {
            const Vector<2> P = matter.shear * F[a] + share * J_inverse_transposed[a];
            out.PB[a] = inverse_times<2>(i.B, P);
        }
        const double squares = dot(F[0], F[0]) + dot(F[1], F[1]);
        out.elastic =
            i.V * (0.5 * matter.shear * (squares - 2 - 2 * log_J) + 0.5 * matter.lame() * log_J * log_J);
    }
};
// [end]

// [reference-force]
/// m_i dv_i/dt = V_i sum_j V_j (P_i B_i^-1 + P_j B_j^-1) grad_i W(X_ij): minus the derivative of the energy
/// sum V Psi with respect to x_i. What i gets, j loses; and an energy that no rotation changes has forces
/// without a torque.
struct ReferenceForce {
    using Reads = List<ReferenceStress>;
    using ReadsI = List<Mass, Volume>;
    using ReadsJ = List<Volume>;
    using Adds = List<Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.dv_dt += (i.V / i.m * j.V * pair.F) * times(i.PB + j.PB, pair.x_ij);
    }
};
// [end]

/// dv_i/dt = - alpha K V_i/(2 m_i) sum_j V_j W(X_ij)/X_ij^2 (delta_i + delta_j) x_ij/r_ij, where delta_i =
/// (x_ij - F_i X_ij) . x_ij/r_ij is by how much a pair is longer than the deformation gradient of i says
/// (Ganzenmueller 2015, 17-24): against hourglass modes, motions that no F sees. Along x_ij and opposite for
/// i and j. DisplacementGradient holds F - 1 here, corrected. stiffness = alpha K >= 0   [pressure].
struct HourglassForce {
    double stiffness;
    using Reads = List<Displacement, DisplacementGradient>;
    using ReadsI = List<Mass, Volume>;
    using ReadsJ = List<Volume>;
    using Adds = List<Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        // A particle has no length to itself. A square of 1e-150 is none, and divides any W without overflow.
        constexpr double tiny = 1e-150;
        const auto u = i.moved - j.moved;
        const auto x = pair.x_ij + u;
        const auto jump = 2.0 * u - times(i.H + j.H, pair.x_ij);
        const Tile longer = dot(jump, x) / dot(x, x).max(tiny);
        const Tile near = pair.W / dot(pair.x_ij, pair.x_ij).max(tiny);
        sum.dv_dt -= (0.5 * stiffness * i.V / i.m * j.V * near * longer) * x;
    }
};

/// dv_i/dt = f_i, a force by mass that the scene gives   [length/time^2].
struct Load {
    static constexpr std::string_view name = "load";
    template <class T, int d>
    struct In {
        Vec<T, d> load{};
    };
};
struct GivenForce {
    using ReadsI = List<Load>;
    using Writes = List<Acceleration>;
    void finish(const auto& i, const auto&, auto& out) const { out.dv_dt += i.load; }
};

}  // namespace sph
