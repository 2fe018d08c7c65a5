#pragma once
#include "chapters/04_artificial_viscosity/dissipation.hpp"

/// Artificial viscosities, in the order in which they were found. Each gives Pi_ij >= 0 for particles that
/// approach each other and 0 for those that recede.
namespace sph {

/// No viscosity: for the question what goes wrong without it.
struct NoViscosity {};

/// A viscous pressure of each particle, added to its pressure   (Monaghan & Gingold 1983; Chen 2017, figure
/// 8): Pi_ij = q_i/rho_i^2 + q_j/rho_j^2. The q come from the divergence of the velocity, a sum over many
/// neighbours, so they do not see two particles approach each other within it.
struct ViscousPressure {
    static constexpr std::string_view name = "viscous pressure";
    template <class T, int>
    struct In {
        T q{};
    };
};
struct BulkPressure {
    using Reads = List<ViscousPressure, Density>;
    Tile pressure(const auto& i, const auto& j, const auto&) const {
        return i.q / (i.rho * i.rho) + j.q / (j.rho * j.rho);
    }
};

/// Pi_ij = -nu v_ij . x_ij/(r^2 + epsilon h^2), nu = h/rho (alpha c - beta h v_ij . x_ij/(r^2 + epsilon
/// h^2)), with the means of h, c_s and rho   (8.3, 8.4 for beta = 0, Monaghan & Gingold 1983; 8.10, Monaghan
/// 1992).
struct AlphaBeta {
    double alpha = 1, beta = 2, epsilon = 0.01;
    static constexpr auto knobs() {
        return std::tuple{Knob{"alpha", &AlphaBeta::alpha, {0, 10}, "strength of the linear term"},
                          Knob{"beta", &AlphaBeta::beta, {0, 20}, "strength of the quadratic term"},
                          Knob{"epsilon", &AlphaBeta::epsilon, {0, 1, true}, "keeps near pairs finite"}};
    }
    // [alpha-beta]
    using Reads = List<MiddleVelocity, SoundSpeed, Density, SmoothingLength>;
    Tile pressure(const auto& i, const auto& j, const auto& pair) const {
        const Tile h = 0.5 * (i.h + j.h);
        const Tile mu = h * dot(i.v_mid - j.v_mid, pair.x_ij) / (pair.r * pair.r + epsilon * h * h);
        const Tile approach = mu.min(0.0);
        return approach * (beta * approach - alpha * 0.5 * (i.c_s + j.c_s)) / (0.5 * (i.rho + j.rho));
    }
    // [end]
};

/// Pi_ij = -K v_sig w/rho, v_sig = c_i + c_j - beta w, w = v_ij . x_ij/r   (8.11, 8.12; Monaghan 1997).
/// With K = 0.5 and beta = 4 it is (8.10) for alpha = 1, beta = 2 without its factors h/r and (h/r)^2: on a
/// line with h = 1.2 spacings neighbours at 1 and 2 spacings count 1 and 1 here, 1.18 and 0.60 there (with
/// epsilon). Their sums over all neighbours nearly agree, since r is near h on average.
struct SignalViscosity {
    double K = 0.5, beta = 4;
    static constexpr auto knobs() {
        return std::tuple{Knob{"K", &SignalViscosity::K, {0, 5}, "strength of the viscosity"},
                          Knob{"beta", &SignalViscosity::beta, {0, 20}, "strength of the quadratic term"}};
    }
    using Reads = List<MiddleVelocity, SoundSpeed, Density>;
    Tile pressure(const auto& i, const auto& j, const auto& pair) const {
        return of(closing_speed(i.v_mid - j.v_mid, pair), i, j);
    }
    /// The same for a closing speed w that is known otherwise.
    Tile of(const Tile& w, const auto& i, const auto& j) const {
        const Tile approach = w.min(0.0);
        return K * approach * (beta * approach - (i.c_s + j.c_s)) / (0.5 * (i.rho + j.rho));
    }
};

/// A viscosity times the mean of a factor that each particle carries: alpha of Morris & Monaghan, or the
/// factors of Balsara and Colagrossi (switches.hpp).
template <class Viscosity, class Factor>
struct Scaled {
    Viscosity viscosity;
    static auto parts(auto& self) { return std::tie(self.viscosity); }
    using Reads = Union<typename Viscosity::Reads, List<Factor>>;
    Tile pressure(const auto& i, const auto& j, const auto& pair) const {
        return 0.5 * (Factor::of(i) + Factor::of(j)) * viscosity.pressure(i, j, pair);
    }
};

}  // namespace sph
