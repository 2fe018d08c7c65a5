#pragma once
#include "chapters/04_artificial_viscosity/reconstruction.hpp"
#include "chapters/08_landau_model/entropic_fluid.hpp"

/// What a relativistic gas of baryons of mass 1 needs to pass shocks, as pair effects: exchanges of momentum
/// and of energy per baryon that are antisymmetric, so that the totals stand still whatever the time step. In
/// one dimension.
namespace sph {

/// n* = lorentz n, by volume in the laboratory.
struct BaryonDensity {
    static constexpr std::string_view name = "baryon density in the laboratory";
    static constexpr bool positive = true;
    template <class T, int>
    struct In {
        T n_star{};
    };
};
/// Chapter 3's density and pressure force, and chapter 4's slopes, counted in baryons: m is their number.
struct OfBaryons {
    using Amount = Mass;
    using PerVolume = BaryonDensity;
    template <class Effect>
    using Counted = Renamed<Effect, As<Density, BaryonDensity>, As<Acceleration, MomentumRate>>;
};

/// E = h lorentz - P/n*.
struct EnergyPerBaryon {
    static constexpr std::string_view name = "energy per baryon";
    static constexpr bool positive = true;
    static constexpr bool held = true;
    template <class T, int>
    struct In {
        T E{};
    };
};
struct EnergyRate {
    static constexpr std::string_view name = "rate of energy per baryon";
    template <class T, int>
    struct In {
        T dE_dt{};
    };
};
/// h = 1 + gamma u, at rest.
struct Enthalpy {
    static constexpr std::string_view name = "enthalpy per baryon";
    template <class T, int>
    struct In {
        T h_enthalpy{};
    };
};
/// y = artanh v: the velocity that adds.
struct Rapidity {
    static constexpr std::string_view name = "rapidity";
    template <class T, int>
    struct In {
        T y{};
    };
};
struct RapidityGradient : GradientOf<RapidityGradient, Rapidity, OfBaryons> {
    static constexpr std::string_view name = "gradient of rapidity";
    template <class T, int d>
    struct In {
        Vec<T, d> dy_dx{};
    };
};
/// Chapter 4's PressureGradient, with volumes m/n*.
struct LabPressureGradient : GradientOf<LabPressureGradient, Pressure, OfBaryons> {
    static constexpr std::string_view name = "gradient of pressure in the laboratory";
    template <class T, int d>
    struct In {
        Vec<T, d> dp_dx{};
    };
};

/// dE_i/dt = - sum_j m_j (P_i v_j/(Omega_i n*_i^2) . grad_i W(h_i) + P_j v_i/(Omega_j n*_j^2) . grad_i
/// W(h_j)): the work of chapter 3's (3.18), with lab-frame densities (Chow & Monaghan 1997).
struct GradHWork {
    using Reads = List<Velocity, BaryonDensity, Pressure, GradH>;
    using ReadsJ = List<Mass>;
    using Adds = List<EnergyRate>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const double from_i = i.p / (i.Omega * i.n_star * i.n_star);
        const Tile from_j = j.p / (j.Omega * j.n_star * j.n_star);
        sum.dE_dt -=
            j.m * (from_i * dot(j.v, pair.x_ij) * F_i(pair) + from_j * dot(i.v, pair.x_ij) * F_j(pair));
    }
};

/// The fastest and the slowest signal of a pair in the laboratory: (v +- c_s)/(1 +- v c_s).
struct LabSignals {
    Tile fastest, slowest;
    LabSignals(const auto& i, const auto& j) {
        const double v = i.v[0], c = i.c_s;
        const double right = (v + c) / (1 + v * c), left = (v - c) / (1 - v * c);
        fastest = ((j.v[0] + j.c_s) / (1.0 + j.v[0] * j.c_s)).max(right);
        slowest = ((j.v[0] - j.c_s) / (1.0 - j.v[0] * j.c_s)).min(left);
    }
    Tile spread() const { return fastest - slowest; }
};

/// Of particles that approach each other,
///     dq_i/dt = sum_j m_j K v_sig/n* (q_i - q_j) r F,   dE_i/dt = sum_j m_j K v_sig/n* (E_i - E_j) r F,
///     v_sig = sum_{k = i, j} (c_k + |w|)/(1 + c_k |w|) + |w|,   w = (v_i - v_j)/(1 - v_i v_j),
/// with r F <= 0, n* the mean. Conducts wherever it acts. (Chow & Monaghan 1997, J. Comput. Phys. 134, 296;
/// Monaghan 2005, section 12.)
struct ChowMonaghan {
    double K = 0.5;
    static constexpr auto knobs() {
        return std::tuple{Knob{"K", &ChowMonaghan::K, {0, 5}, "strength of the exchange"}};
    }
    using Reads = List<Velocity, MomentumPerCharge, EnergyPerBaryon, SoundSpeed, BaryonDensity>;
    using ReadsJ = List<Mass>;
    using Adds = List<MomentumRate, EnergyRate>;
    // [exchange]
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const Tile w = ((i.v[0] - j.v[0]) / (1.0 - i.v[0] * j.v[0])).abs();
        const Tile v_sig = (i.c_s + w) / (1.0 + i.c_s * w) + (j.c_s + w) / (1.0 + j.c_s * w) + w;
        const Tile approach = ((i.v[0] - j.v[0]) * pair.x_ij[0] < 0).select(v_sig, 0.0);
        const Tile weight = K * j.m * approach / (0.5 * (i.n_star + j.n_star)) * pair.r * mean_F(pair);
        sum.dq_dt[0] += weight * (i.q[0] - j.q[0]);
        sum.dE_dt += weight * (i.E - j.E);
    }
    // [end]
};

/// The same, but of the jump in rapidity that both particles' slopes leave between them (chapter 4,
/// reconstruction.hpp), dy = n (y_i - y_j) - r s < 0, s = van Leer's mean slope, distrusted beyond c_s, and
/// with the signals of the laboratory: moving gas is contracted and its clocks are slow, so that its v_sig is
/// 1/lorentz^2 of that at rest. A jump dy about the mean rapidity y exchanges
///     momentum  2 h sinh(dy/2) cosh y,   energy  2 h sinh(dy/2) sinh y,   h the mean enthalpy:
/// in the mean rest frame of the pair a momentum, and no energy. That moves the lighter of the two by
/// h/min(h_i, h_j) times the rate at which it would move its equal, and by this the step is limited: a light
/// particle beside hot gas would else be thrown to and fro until it has lost its heat.
struct ReconstructedExchange {
    static constexpr double largest_jump = 50;
    double K = 0.85;
    static constexpr auto knobs() {
        return std::tuple{Knob{"K", &ReconstructedExchange::K, {0, 5}, "strength of the exchange"}};
    }
    using Reads = List<Velocity, Rapidity, RapidityGradient, SoundSpeed, BaryonDensity, Enthalpy>;
    using ReadsJ = List<Mass>;
    using Adds = List<MomentumRate, EnergyRate, StepRate>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const Tile n = pair.x_ij[0] / pair.r.max(std::numeric_limits<double>::min());
        const Tile w = n * (i.y - j.y), c = 0.5 * (i.c_s + j.c_s);
        const Tile slope = common_slope(j.dy_dx[0], i.dy_dx[0]) * (c * c / (c * c + w * w));
        // Bounded: lanes behind the last neighbour are far away, and 0 times infinity is no weight.
        const Tile half = (0.5 * (w - pair.r * slope)).min(0.0).max(-largest_jump), y = 0.5 * (i.y + j.y);
        const Tile jump = half.exp() - (-half).exp(), e = y.exp();
        const Tile enthalpy = 0.5 * (i.h_enthalpy + j.h_enthalpy);
        const Tile rate =
            K * j.m * LabSignals{i, j}.spread() / (0.5 * (i.n_star + j.n_star)) * pair.r * mean_F(pair);
        const Tile weight = rate * jump * n * enthalpy;
        const Tile share = half / (0.5 * w).min(half).min(-std::numeric_limits<double>::min());
        sum.step_rate = sum.step_rate.max(-rate * share * enthalpy / j.h_enthalpy.min(i.h_enthalpy));
        sum.dq_dt[0] += weight * 0.5 * (e + 1.0 / e);
        sum.dE_dt += weight * 0.5 * (e - 1.0 / e);
    }
};

/// Thermal energy exchanged in the mean rest frame of a pair, at chapter 4's ContactSpeed: v_u =
/// alpha_u sqrt(|dP|/(n h)), at most `cap` of the smaller speed of sound, 1/lorentz^2 of it in the
/// laboratory; dP is the jump that the common slope of the pressure leaves. alpha_u >= 0.
struct ContactConduction {
    double alpha_u = 2, cap = 0.2;
    static constexpr auto knobs() {
        return std::tuple{
            Knob{"alpha-u", &ContactConduction::alpha_u, {0, 10}, "strength of the conduction"},
            Knob{"cap", &ContactConduction::cap, {0, 2}, "its largest speed in speeds of sound"}};
    }
    using Reads =
        List<ThermalEnergy, Rapidity, Pressure, LabPressureGradient, SoundSpeed, BaryonDensity, Enthalpy>;
    using ReadsJ = List<Mass>;
    using Adds = List<MomentumRate, EnergyRate>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const Tile slope = common_slope(j.dp_dx[0] * pair.x_ij[0], i.dp_dx[0] * pair.x_ij[0]);
        const Tile e = (0.5 * (i.y + j.y)).exp(), cosh = 0.5 * (e + 1.0 / e), sinh = 0.5 * (e - 1.0 / e);
        const Tile inertia = 0.5 * (i.n_star * i.h_enthalpy + j.n_star * j.h_enthalpy) / cosh;
        const Tile v_u = alpha_u * (((i.p - j.p) - slope).abs() / inertia).sqrt();
        const Tile limited = v_u.min(cap * j.c_s.min(i.c_s)) / (cosh * cosh);
        const Tile weight =
            j.m * limited * (i.u - j.u) / (0.5 * (i.n_star + j.n_star)) * pair.r * mean_F(pair);
        sum.dq_dt[0] += weight * sinh;
        sum.dE_dt += weight * cosh;
    }
};

/// The rate that limits the step: the fastest signal past either particle over the mean h (in front of a
/// strong shock the smaller one would cost three times the steps for the same errors), and the speed at which
/// the distance changes over the distance.
struct LabSignalRate {
    using Reads = List<Velocity, SoundSpeed, SmoothingLength>;
    using Adds = List<StepRate>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const LabSignals lab{i, j};
        const Tile ahead = lab.fastest - j.v[0].min(i.v[0]), behind = j.v[0].max(i.v[0]) - lab.slowest;
        const Tile distance = pair.r.max(std::numeric_limits<double>::min());
        const Tile rate = (ahead.max(behind) / (0.5 * (i.h + j.h))).max((i.v[0] - j.v[0]).abs() / distance);
        sum.step_rate = sum.step_rate.max((mean_F(pair) < 0).select(rate, 0.0));
    }
};

}  // namespace sph
