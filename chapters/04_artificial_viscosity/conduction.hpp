#pragma once
#include "chapters/04_artificial_viscosity/viscosities.hpp"

/// Artificial conduction: thermal energy exchanged between neighbours, so that it has no jump that the
/// density cannot follow.
namespace sph {

struct NoConduction {};

/// du_i/dt = sum_j m_j alpha_u v_u (u_i - u_j)/rho r F, r F <= 0   (8.23, with a signal speed v_u of its
/// own). Antisymmetric: what i loses, j gains. alpha_u >= 0 [-]; Speed gives v_u [velocity], symmetric.
template <class Speed>
struct Conduction {
    Speed speed;
    static auto parts(auto& self) { return std::tie(self.speed); }
    using Reads = Union<List<ThermalEnergy, Density>, typename Speed::Reads>;
    using ReadsJ = List<Mass>;
    using Adds = List<Heating>;
    // [conduction]
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const Tile v_u = speed.of(i, j, pair);
        sum.du_dt += j.m * v_u * (i.u - j.u) / (0.5 * (i.rho + j.rho)) * pair.r * mean_F(pair);
    }
    // [end]
};

/// v_u = K v_sig, v_sig = c_i + c_j - beta w, for particles that approach each other (w < 0), as the
/// viscosity: what the dissipation of the thermokinetic energy (8.18-8.20) does to u   (8.23; Monaghan 1997,
/// J. Comput. Phys. 136, 298, section 4)
struct SignalSpeed {
    double K = 0.5, beta = 4;
    static constexpr auto knobs() {
        return std::tuple{
            Knob{"K", &SignalSpeed::K, {0, 5}, "strength of the conduction"},
            Knob{"beta", &SignalSpeed::beta, {0, 20}, "part of the closing speed in the signal"}};
    }
    using Reads = List<MiddleVelocity, SoundSpeed>;
    Tile of(const auto& i, const auto& j, const auto& pair) const {
        const Tile w = closing_speed(i.v_mid - j.v_mid, pair);
        return (w < 0).select(of_all(w.min(0.0), i, j), 0.0);
    }
    /// The same whether they approach or not, for w <= 0.
    Tile of_all(const Tile& approach, const auto& i, const auto& j) const {
        return K * (i.c_s + j.c_s - beta * approach);
    }
};
/// SignalSpeed between all neighbours: conducts in a fan too, where nothing is to be repaired.
struct SignalSpeedOfAll {
    SignalSpeed signal;
    static auto parts(auto& self) { return std::tie(self.signal); }
    using Reads = SignalSpeed::Reads;
    Tile of(const auto& i, const auto& j, const auto& pair) const {
        return signal.of_all(closing_speed(i.v_mid - j.v_mid, pair).min(0.0), i, j);
    }
};

/// The strength of a particle's conduction.
struct ConductionAlpha {
    static constexpr std::string_view name = "alpha of conduction";
    template <class T, int>
    struct In {
        T alpha_u{};
    };
};
/// v_u = (alpha_u,i + alpha_u,j)/2 (c_i + c_j)/2 with an alpha_u of each particle's own   (Price 2004, after
/// 8.28).
struct OwnSpeed {
    using Reads = List<ConductionAlpha, SoundSpeed>;
    Tile of(const auto& i, const auto& j, const auto&) const {
        return 0.25 * (i.alpha_u + j.alpha_u) * (i.c_s + j.c_s);
    }
};

}  // namespace sph
