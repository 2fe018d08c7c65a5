#pragma once
#include "chapters/04_artificial_viscosity/conduction.hpp"
#include "chapters/04_artificial_viscosity/slopes.hpp"

/// Dissipation that looks at what is left of a difference when both particles' slopes are taken out: a jump.
/// Where the flow is smooth almost nothing is left.
namespace sph {

/// The slope that two slopes agree on: their harmonic mean 2 a b/(a + b) where they have one sign, else 0. It
/// is van Leer's limiter: where they differ it falls to the smaller one (at most twice that).
inline Tile common_slope(const Tile& a, const Tile& b) {
    const Tile sum = a + b;
    return 2.0 * (a * b).max(0.0) * sum / (sum * sum).max(std::numeric_limits<double>::min());
}

/// The signal viscosity for the velocities that both particles' slopes predict half-way between them: what is
/// left of v_ij is a jump. (Frontiere, Raskin & Owen
/// 2017, J. Comput. Phys. 332, 160, section 2.4; Rosswog 2020, MNRAS 498, 4230, section 2.3.)
///     w = v_ij . n - r s, n = x_ij/r, s = 2 g_i g_j/(g_i + g_j) for g_i g_j > 0 and else 0, g = n . grad v .
///     n
/// s is the harmonic mean of the slopes, which is van Leer's limiter: in a shock they differ, and it falls to
/// the smaller one.
/// Two neighbours whose velocities differ by more than the speed of sound are in a shock, however straight
/// the velocity is there: s is multiplied by c_s^2/(c_s^2 + w^2). Without this, cold gas that stays cold
/// (gamma near 1) falls onto itself in a profile that is linear, and nothing resists.
struct ReconstructedViscosity {
    SignalViscosity signal;
    double slopes = 1;  ///< the part of r s that is taken out; 0 leaves the signal viscosity
    static auto parts(auto& self) { return std::tie(self.signal); }
    static constexpr auto knobs() {
        return std::tuple{
            Knob{"slopes", &ReconstructedViscosity::slopes, {0, 1}, "part of the common slope taken out"}};
    }
    using Reads = Union<SignalViscosity::Reads, List<VelocityGradient>>;
    // [reconstructed]
    Tile pressure(const auto& i, const auto& j, const auto& pair) const {
        const Tile r2 = (pair.r * pair.r).max(std::numeric_limits<double>::min());
        const Tile g_i = along(i.dv_dx, pair.x_ij) / r2, g_j = along(j.dv_dx, pair.x_ij) / r2;
        const Tile w = closing_speed(i.v_mid - j.v_mid, pair), c = 0.5 * (i.c_s + j.c_s);
        const Tile slope = common_slope(g_i, g_j) * (c * c / (c * c + w * w));
        return signal.of(w - slopes * pair.r * slope, i, j);
    }
    // [end]

  private:
    static Tile along(const auto& gradient, const auto& x) {
        Tile sum = x[0] * dot(gradient[0], x);
        for (std::size_t a = 1; a < x.size(); ++a) sum += x[a] * dot(gradient[a], x);
        return sum;
    }
};

/// v_u = alpha_u sqrt(|dP|/rho) (Price 2008, J. Comput. Phys. 227, 10040, eq. 18, with dP = P_i - P_j), at
/// most `cap` times the smaller speed of sound; here dP is P_i - P_j less what the common slope of the
/// pressure explains. Works at a contact, whose pressure the sums make uneven, until it is even; leaves
/// smooth waves alone; and cold gas that a shock has not reached yet conducts nothing.
struct ContactSpeed {
    double alpha_u = 1, cap = 0.2;
    static constexpr auto knobs() {
        return std::tuple{Knob{"alpha-u", &ContactSpeed::alpha_u, {0, 10}, "strength of the conduction"},
                          Knob{"cap", &ContactSpeed::cap, {0, 2}, "its largest speed in speeds of sound"}};
    }
    using Reads = List<Pressure, Density, SoundSpeed, PressureGradient>;
    Tile of(const auto& i, const auto& j, const auto& pair) const {
        const Tile slope = common_slope(dot(i.dp_dx, pair.x_ij), dot(j.dp_dx, pair.x_ij));
        const Tile jump = ((i.p - j.p) - slope).abs();
        const Tile v_u = alpha_u * (jump / (0.5 * (i.rho + j.rho))).sqrt();
        return v_u.min(cap * j.c_s.min(i.c_s));
    }
};

}  // namespace sph
