#pragma once
#include "chapters/04_artificial_viscosity/reconstruction.hpp"
#include "chapters/07_godunov_sph/riemann.hpp"
#include "chapters/07_godunov_sph/volumes.hpp"

/// The states on both sides of the place where two particles meet: those of the particles, or what their
/// slopes say of that place.
namespace sph {

/// grad v, dv_a/dx_b   [1/time].
struct FlowGradient : GradientOf<FlowGradient, Velocity> {
    static constexpr std::string_view name = "gradient of the flow";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> dv_dx{};
    };
};

/// What the sides need of the step, of the gas and of the kernel (convolved.hpp).
struct StepOfSides {
    double dt;            ///< for the way that sound goes in it
    double gamma;         ///< > 1
    double bend, reach2;  ///< of the kernel [h^2]
    double order = 1;     ///< 1, or 0 for a step without slopes
};
/// Right is i, left is j.
struct TwoSides {
    Beside left, right;
};

/// n . g . n of a tensor, n a unit vector.
Tile along(const auto& gradient, const auto& n) {
    Tile sum = n[0] * dot(gradient[0], n);
    for (std::size_t a = 1; a < n.size(); ++a) sum += n[a] * dot(gradient[a], n);
    return sum;
}

/// First order: the particles' own states.
struct ConstantSides {
    using Reads = List<Velocity, Density, Pressure>;
    using Slopes = List<>;
    template <int d>
    TwoSides meet(const auto& i, const auto& j, const Vec<Tile, d>& n, const Tile&, const Tile&,
                  const StepOfSides&) const {
        return {{j.rho, j.p, dot(j.v, n)}, {i.rho, i.p, dot(i.v, n)}};
    }
};

/// Second order as the paper has it   (Inutsuka 2002, 68, 74, 75): with each particle's slopes at s, as far
/// as sound has come from there in half a step, f_R = f_i + f'_i (s + c_i dt/2 - s_i). The slopes of the
/// velocity count where they have one sign (74); none counts where particles approach by more than the speed
/// of sound over C_shock (75). The paper does not say what happens where a density or pressure would not be
/// positive, which its first step in a tube needs: here, the particle's own state.
struct PaperConstraint {
    double C_shock = 3;
    static constexpr auto knobs() {
        return std::tuple{
            Knob{"C-shock", &PaperConstraint::C_shock, {0, 100}, "how many particles share a shock"}};
    }
    using Reads =
        List<Velocity, Density, Pressure, SoundSpeed, FlowGradient, FittedDensitySlope, PressureGradient>;
    using Slopes = List<FlowGradient, FittedDensitySlope, PressureGradient>;
    template <int d>
    TwoSides meet(const auto& i, const auto& j, const Vec<Tile, d>& n, const Tile& r, const Tile& s,
                  const StepOfSides& step) const {
        const Tile v_i = dot(i.v, n), v_j = dot(j.v, n);
        const auto in_shock = C_shock * (v_j - v_i) > j.c_s.min(i.c_s);
        const Tile to_i = in_shock.select(0.0, step.order * (s + 0.5 * step.dt * i.c_s - 0.5 * r));
        const Tile to_j = in_shock.select(0.0, step.order * (s - 0.5 * step.dt * j.c_s + 0.5 * r));
        const Tile dv_i = along(i.dv_dx, n), dv_j = along(j.dv_dx, n);
        const auto agree = dv_i * dv_j >= 0.0;
        const auto side = [&](const auto& of, const Tile& own, const Tile& slope, const Tile& way) {
            const Tile rho = of.rho + dot(of.drho_dx, n) * way, p = of.p + dot(of.dp_dx, n) * way;
            const auto positive = (rho > 0.0) & (p > 0.0);
            return Beside{positive.select(rho, of.rho), positive.select(p, of.p),
                          positive.select(own + agree.select(slope * way, 0.0), own)};
        };
        return {side(j, v_j, dv_j, to_j), side(i, v_i, dv_i, to_i)};
    }
};

/// Where a step's sound comes from, in parts of r from half-way towards either particle.
struct Shifts {
    Tile i, j;
};
Shifts shifts_of(const auto& i, const auto& j, const Tile& r, const Tile& s, double dt) {
    return {(s + 0.5 * dt * i.c_s) / r, (0.5 * dt * j.c_s - s) / r};
}

/// Second order with van Leer's limiter: the change that particle i expects on the way to j is limited by the
/// change that there is. With D = f_i - f_j and D' = 2 r f'_i - D, the change on the other side of i, the
/// slope is their harmonic mean, 2 D D'/(D + D') where they have one sign, else 0. The place is never farther
/// from a particle than half-way, so that a side's value lies between both particles': density and pressure
/// stay positive. Where particles approach by more than the speed of sound over C_shock: first order.
struct VanLeer {
    double C_shock = 3;
    static constexpr auto knobs() {
        return std::tuple{Knob{"C-shock", &VanLeer::C_shock, {0, 100}, "how many particles share a shock"}};
    }
    using Reads = PaperConstraint::Reads;
    using Slopes = PaperConstraint::Slopes;
    // [van-leer]
    template <int d>
    TwoSides meet(const auto& i, const auto& j, const Vec<Tile, d>& n, const Tile& r, const Tile& s,
                  const StepOfSides& step) const {
        const Tile v_i = dot(i.v, n), v_j = dot(j.v, n);
        const auto in_shock = C_shock * (v_j - v_i) > j.c_s.min(i.c_s);
        const Shifts shift = shifts_of(i, j, r, s, step.dt);
        const Tile to_i = in_shock.select(0.0, step.order * (0.5 - shift.i).max(0.0).min(0.5));
        const Tile to_j = in_shock.select(0.0, step.order * (0.5 - shift.j).max(0.0).min(0.5));
        const auto change_to = [&](const Tile& change, const Tile& slope, const Tile& way) {
            return way * common_slope(change, 2.0 * r * slope - change);
        };
        const Tile drho = i.rho - j.rho, dp = i.p - j.p, dv = v_i - v_j;
        const auto side = [&](const auto& of, const Tile& v, const Tile& way) {
            return Beside{of.rho + change_to(drho, dot(of.drho_dx, n), way),
                          of.p + change_to(dp, dot(of.dp_dx, n), way),
                          v + change_to(dv, along(of.dv_dx, n), way)};
        };
        return {side(j, v_j, to_j), side(i, v_i, -to_i)};
    }
    // [end]
};

/// Third order in smooth flow. Between i and j the change is D = f_i - f_j, and both slopes leave of it
///     bent = r (f'_i - f'_j)/2,   left = r (f'_i + f'_j)/2 - D.
/// What lies half-way is f_i - [D + (1 - kappa) (bent + b left)]/2 seen from i and f_j + [D + (1 - kappa) (b
/// left - bent)]/2 from j; sound comes dt c/2 from there, along D/r. With
///     kappa = 1/3 - (4/reach2) [bend - (gamma/3 - 1/4) X^2]/(2 gamma - 1),   X = c dt/h,
/// a sound wave has no error of phase below the fourth power of k h (derived in README.md); b = `jump` is
/// what is left of the jump that damps it. The way from either particle is limited: it ends at the other's
/// value, is no longer than the change on the other side, D' = 2 r f' - D, and is 0 where D and D' have
/// different signs, but for `little` of the values themselves (of the speed of sound for velocities). Where
/// particles approach by more than the speed of sound over C_shock: first order. In more than one dimension
/// `across` of what half a step changes in the pressure across the line comes in too; without it the step is
/// a viscosity in shear, of the order of c_s^2 dt.
struct ThirdOrder {
    double C_shock = 3, jump = 0.5, little = 1e-4, across = 1;
    static constexpr auto knobs() {
        return std::tuple{
            Knob{"C-shock", &ThirdOrder::C_shock, {0, 100}, "how many particles share a shock"},
            Knob{"jump", &ThirdOrder::jump, {0, 1}, "part of the jump between slopes in smooth flow"},
            Knob{"little", &ThirdOrder::little, {0, 1}, "relative change that is not limited"},
            Knob{"across", &ThirdOrder::across, {0, 1}, "part of the half step across the pair's line"}};
    }
    using Reads = Union<PaperConstraint::Reads, List<SmoothingLength>>;
    using Slopes = PaperConstraint::Slopes;
    template <int d>
    TwoSides meet(const auto& i, const auto& j, const Vec<Tile, d>& n, const Tile& r, const Tile& s,
                  const StepOfSides& step) const {
        const Tile v_i = dot(i.v, n), v_j = dot(j.v, n);
        const Tile order = (C_shock * (v_j - v_i) > j.c_s.min(i.c_s)).select(0.0, step.order);
        const Shifts shift = shifts_of(i, j, r, s, step.dt);
        const Tile X = step.dt * (i.c_s + j.c_s) / (j.h + i.h);
        const auto halves = [&](const Tile& change, const Tile& slope_i, const Tile& slope_j,
                                const Tile& scale) {
            const Tile bent = 0.5 * r * (slope_i - slope_j);
            const Tile left = jump * (0.5 * r * (slope_i + slope_j) - change), rest = one_less_kappa(X, step);
            const Tile from_i = 0.5 * (change + rest * (left + bent)) - shift.i * change;
            const Tile from_j = 0.5 * (change + rest * (left - bent)) - shift.j * change;
            return std::pair{order * limited(from_i, change, 2.0 * r * slope_i - change, little * scale),
                             order * limited(from_j, change, 2.0 * r * slope_j - change, little * scale)};
        };
        const auto [rho_i, rho_j] =
            halves(i.rho - j.rho, dot(i.drho_dx, n), dot(j.drho_dx, n), j.rho.min(i.rho));
        const auto [p_i, p_j] = halves(i.p - j.p, dot(i.dp_dx, n), dot(j.dp_dx, n), j.p.min(i.p));
        const Tile g_i = along(i.dv_dx, n), g_j = along(j.dv_dx, n);
        const auto [to_i, to_j] = halves(v_i - v_j, g_i, g_j, j.c_s.min(i.c_s));
        const Tile part = across * order;
        const Tile left_i = kept(part, i.dv_dx, g_i, step), left_j = kept(part, j.dv_dx, g_j, step);
        return {{j.rho + rho_j, (j.p + p_j) * left_j, v_j + to_j},
                {i.rho - rho_i, (i.p - p_i) * left_i, v_i - to_i}};
    }

  private:
    /// What half a step across the line between the particles leaves of a pressure. Sound from along the line
    /// has n . grad v . n for the divergence, which is all of it in one dimension only.
    // [across]
    static Tile kept(const Tile& part, const auto& gradient, const Tile& along_line,
                     const StepOfSides& step) {
        Tile across = -along_line;
        for (std::size_t a = 0; a < gradient.size(); ++a) across += gradient[a][a];
        return 1.0 - part * (0.5 * step.gamma * step.dt * across).max(-0.5).min(0.5);
    }
    // [end]
    // [kappa]
    static Tile one_less_kappa(const Tile& X, const StepOfSides& step) {
        const Tile waits = step.bend - (step.gamma / 3 - 0.25) * X * X;
        return 2.0 / 3 + 4 / (step.reach2 * (2 * step.gamma - 1)) * waits;
    }
    /// The way `wanted`, no farther than `change` and the change on the other side allow.
    static Tile limited(const Tile& wanted, const Tile& change, const Tile& other, const Tile& free) {
        const Tile most = (change * other > 0.0).select(change.abs().min(other.abs()), 0.0) + free;
        const auto up = change > 0.0;
        const Tile ahead = up.select(wanted, -wanted).max(-free).min(most);
        return up.select(ahead, -ahead);
    }
    // [end]
};

}  // namespace sph
