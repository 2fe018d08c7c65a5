#pragma once
#include <algorithm>
#include <cmath>

#include "chapters/02_consistency/corrected.hpp"

/// Elastic solids that move with their particles (Monaghan 2005, section 11): Hooke's law with the Jaumann
/// rate, the force of a stress, and what keeps particles under tension apart. Two dimensions are a plane
/// strain: the third axis does not stretch, but is stressed.
namespace sph {

/// An isotropic elastic material. bulk K > 0 and shear mu > 0 [pressure], rho0 > 0: density without stress.
struct Elastic {
    double bulk = 1, shear = 1, rho0 = 1;

    double lame() const { return bulk - 2 * shear / 3; }  ///< lambda [pressure]
    double sound_speed() const { return std::sqrt(bulk / rho0); }
    /// c_l = sqrt((K + 4 mu/3)/rho), of waves that compress; c_t = sqrt(mu/rho), of waves that shear.
    double longitudinal_speed() const { return std::sqrt((bulk + 4 * shear / 3) / rho0); }
    double transverse_speed() const { return std::sqrt(shear / rho0); }
    double young() const { return 9 * bulk * shear / (3 * bulk + shear); }                ///< E
    double poisson() const { return (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear)); }  ///< nu
    /// P = c0^2 (rho - rho0), c0^2 = K/rho0, and the energy by mass that belongs to it.
    double pressure(double rho) const { return bulk / rho0 * (rho - rho0); }
    double compression_energy(double rho) const {
        return bulk / rho0 * (std::log(rho / rho0) + rho0 / rho - 1);
    }
};

/// S^ab, the part of the stress without its mean [pressure]; symmetric.
struct DeviatoricStress {
    static constexpr std::string_view name = "deviatoric stress";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> S{};
    };
};
struct StressRate {
    static constexpr std::string_view name = "rate of the deviatoric stress";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> dS_dt{};
    };
};
/// sigma^ab = -P delta^ab + S^ab   (11.2) [pressure]; positive where a solid is pulled.
struct Stress {
    static constexpr std::string_view name = "stress";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> sigma{};
    };
};

/// The vector T x of a tensor and a vector.
template <class T, class U, int d>
auto times(const Vec<Vec<T, d>, d>& tensor, const Vec<U, d>& x) {
    Vec<decltype(tensor[0][0] * x[0]), d> product;
    for (std::size_t a = 0; a < product.size(); ++a) product[a] = dot(tensor[a], x);
    return product;
}

// [gradient]
/// (grad v)^ab = d v^a/dx^b = sum_j m_j/rho_j (v_j - v_i)^a d W_ij/dx_i^b   (2.14 of each component). Exact
/// for a common velocity; for a rotation only where neighbours lie evenly all around.
struct DeformationRate {
    static constexpr std::string_view name = "rate of deformation";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> grad_v{};
    };
    using Reads = List<Velocity>;
    using ReadsJ = List<Volume>;
    using Adds = List<DeformationRate>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.grad_v -= outer((j.V * pair.F) * (i.v - j.v), pair.x_ij);
    }
};
// [end]

/// The velocity gradient as it is summed.
struct SummedRate {
    using Uses = List<DeformationRate>;
    static auto gradient(const auto& sum) { return sum.grad_v; }
};
/// The same divided by what the sum makes of x (Bonet & Lok 1999; chapter 2): exact for every linear
/// velocity, so for every rotation.
struct CorrectedRate {
    using Uses = List<DeformationRate, CorrectionMatrix>;
    static auto gradient(const auto& sum) {
        auto grad_v = sum.grad_v;
        for (auto& row : grad_v) row = GuardedSolve{}(sum.B, row, 1.0);
        return grad_v;
    }
};

// [jaumann]
/// dS/dt = 2 mu (D - delta tr D/3) + S Theta^T + Theta S   (11.3-11.5, where Theta is R): Hooke's law for
/// what deforms, and a stress that turns with the matter. D and Theta are the symmetric and the antisymmetric
/// part of grad v. And d rho/dt = - rho tr D. shear = mu > 0 [pressure].
template <class Rate>
struct JaumannRate {
    double shear;
    using Uses = typename Rate::Uses;
    using ReadsI = List<Density, DeviatoricStress>;
    using Writes = List<StressRate, DensityRate>;
    void finish(const auto& i, const auto& sum, auto& out) const {
        const auto g = Rate::gradient(sum);
        double divergence = 0;
        for (std::size_t a = 0; a < g.size(); ++a) divergence += g[a][a];
        for (std::size_t a = 0; a < g.size(); ++a) {
            for (std::size_t b = 0; b < g.size(); ++b) {
                double& rate = out.dS_dt[a][b] = shear * (g[a][b] + g[b][a]);
                if (a == b) rate -= 2 * shear * divergence / 3;
                for (std::size_t c = 0; c < g.size(); ++c)
                    rate += 0.5 * (i.S[a][c] * (g[b][c] - g[c][b]) + (g[a][c] - g[c][a]) * i.S[c][b]);
            }
        }
        out.drho_dt = -i.rho * divergence;
    }
};
// [end]

// [force]
/// dv_i/dt = sum_j m_j (sigma_i/rho_i^2 + sigma_j/rho_j^2) grad_i W_ij   (11.6 without viscosity). Opposite
/// for i and j, so momentum is exact; but not along x_ij, so angular momentum is not.
struct StressForce {
    using Reads = List<Density, Stress>;
    using ReadsJ = List<Mass>;
    using Adds = List<Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const auto pulled_i = times(i.sigma, pair.x_ij);
        const auto pulled_j = times(j.sigma, pair.x_ij);
        sum.dv_dt += (j.m * pair.F) * ((1 / (i.rho * i.rho)) * pulled_i + (1.0 / (j.rho * j.rho)) * pulled_j);
    }
};
// [end]

/// R^ab, a pressure along each axis that is under tension [pressure/density^2].
struct ArtificialStress {
    static constexpr std::string_view name = "artificial stress";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> R{};
    };
};
// [artificial-stress]
/// dv_i/dt = sum_j m_j f^4 (R_i + R_j) grad_i W_ij, f = W_ij/W(dx)   (Monaghan 2000; Gray, Monaghan & Swift
/// 2001, with n = 4): steep, so that it holds off near neighbours and hardly acts on waves. W_dx = W(dx) > 0.
struct ArtificialStressForce {
    double W_dx;
    using Reads = List<ArtificialStress>;
    using ReadsJ = List<Mass>;
    using Adds = List<Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const Tile f = pair.W * (1 / W_dx);
        const auto R_ij = times(i.R + j.R, pair.x_ij);
        sum.dv_dt += (j.m * f.square().square() * pair.F) * R_ij;
    }
};
/// R = - epsilon sigma_k/rho^2 along each principal axis k of the stress that has sigma_k > 0   (Gray et al.
/// 2001, with epsilon = 0.3). rho > 0, epsilon >= 0.
template <int d>
Tensor<d> artificial_stress(const Tensor<d>& sigma, double rho, double epsilon) {
    const Axes<d> axes = axes_of<d>(sigma);
    Tensor<d> R{};
    for (std::size_t k = 0; k < axes.value.size(); ++k) {
        const double tension = std::max(axes.value[k], 0.0);
        const auto n = axes.direction[k];
        R += outer((-epsilon * tension / (rho * rho)) * n, n);
    }
    return R;
}
// [end]

/// dx_i/dt = v_i + epsilon sum_j m_j/rho_ij (v_j - v_i) W_ij, rho_ij the mean   (XSPH, Monaghan 1989): each
/// particle moves with a mean of its neighbours' velocities. Momentum is as before. epsilon in 0..1.
struct TransportVelocity {
    static constexpr std::string_view name = "velocity that moves particles";
    template <class T, int d>
    struct In {
        Vec<T, d> v_x{};
    };
};
struct Xsph {
    double epsilon;
    using Reads = List<Velocity, Density>;
    using ReadsJ = List<Mass>;
    using Adds = List<TransportVelocity>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.v_x -= (2 * epsilon * j.m * pair.W / (i.rho + j.rho)) * (i.v - j.v);
    }
    void finish(const auto& i, const auto&, auto& out) const { out.v_x += i.v; }
};

}  // namespace sph
