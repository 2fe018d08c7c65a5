#pragma once
#include "chapters/04_artificial_viscosity/slopes.hpp"
#include "chapters/07_godunov_sph/convolved.hpp"

/// What stands between two particles: the integral that turns the pressure P* half-way into a force,
///     area n = 1/2 integral over x of 1/rho^2 [d/dx_i - d/dx_j] W(x - x_i) W(x - x_j), twice   (Inutsuka
/// 2002, 23 and 77), n the unit vector from j to i. Along that line V(s) = 1/rho is interpolated; s = 0 is
/// half-way, i stands at s = r/2. Across the line V is taken as even. For Gaussians W_i W_j is the wide
/// kernel of r times a Gaussian of variance <s^2> = h^2/4; other kernels say what stands for it (product).
namespace sph {

/// grad rho by a linear fit   [density/length].
struct FittedDensitySlope : GradientOf<FittedDensitySlope, Density> {
    static constexpr std::string_view name = "fitted gradient of density";
    template <class T, int d>
    struct In {
        Vec<T, d> drho_dx{};
    };
};

/// Between two particles. area <= 0 [1/(density^2 length^(d+1))]; s: the mean of s under 1/rho^2 W W, where
/// the states of both sides are compared [length].
struct Between {
    Tile area, s;
};

/// V(s) = A s^3 + B s^2 + C s + D with the values and the slopes at s = r/2 (i) and -r/2 (j); the straight
/// line where the slopes disagree   (Inutsuka 2002, 60, 61, 49).
struct CubicAlong {
    Tile A, B, C, D;
    CubicAlong(const Tile& V_i, const Tile& V_j, const Tile& slope_i, const Tile& slope_j, const Tile& r) {
        const Tile change = (V_i - V_j) / r;
        const auto agree = slope_i * slope_j >= 0.0;
        A = agree.select((slope_i + slope_j - 2.0 * change) / (r * r), 0.0);
        B = agree.select(0.5 * (slope_i - slope_j) / r, 0.0);
        C = agree.select(1.5 * change - 0.25 * (slope_i + slope_j), change);
        D = 0.5 * (V_i + V_j) - 0.25 * B * r * r;
    }
    // [cubic]
    /// The mean of V^2 for <s^2> = s2, <s^4> = 3 s2^2, <s^6> = 15 s2^3   (64)
    Tile squared(const Tile& s2) const {
        return ((15.0 * A * A * s2 + 3.0 * (2.0 * A * C + B * B)) * s2 + 2.0 * B * D + C * C) * s2 + D * D;
    }
    /// The mean of s V^2   (65 without its denominator)
    Tile moment(const Tile& s2) const {
        return ((30.0 * A * B * s2 + 6.0 * (A * D + B * C)) * s2 + 2.0 * C * D) * s2;
    }
    // [end]
};

namespace volumes_detail {
/// Half of the integral with the h of either particle   (79).
Between of_both_h(const auto& i, const auto& j, const Tile& r, const auto& kernel, const auto& V) {
    const Tile s2_i = kernel.product * i.h * i.h, s2_j = kernel.product * j.h * j.h;
    const Tile V2_i = V.squared(s2_i), V2_j = V.squared(s2_j);
    return {r * (V2_i * kernel.wide_F(r, Tile{i.h}) + V2_j * kernel.wide_F(r, j.h)),
            0.5 * (V.moment(s2_i) / V2_i + V.moment(s2_j) / V2_j)};
}
}  // namespace volumes_detail

/// V(s) = C s + D   (48-57), and half of the integral with the h of either   (79).
struct LinearVolume {
    using Reads = List<Density, SmoothingLength>;
    using Slopes = List<>;
    template <int d>
    Between face(const auto& i, const auto& j, const Vec<Tile, d>&, const Tile& r, const auto& kernel) const {
        const Tile V_i = 1.0 / i.rho, V_j = 1.0 / j.rho, slope = (V_i - V_j) / r;
        return volumes_detail::of_both_h(i, j, r, kernel, CubicAlong{V_i, V_j, slope, slope, r});
    }
};

/// V(s) cubic   (60-65), and half of the integral with the h of either   (79).
struct CubicVolume {
    /// The straight line all the same, as LinearVolume has it: to compare both without compiling both.
    bool straight = false;
    using Reads = List<Density, SmoothingLength, FittedDensitySlope>;
    using Slopes = List<FittedDensitySlope>;
    template <int d>
    Between face(const auto& i, const auto& j, const Vec<Tile, d>& n, const Tile& r,
                 const auto& kernel) const {
        const Tile V_i = 1.0 / i.rho, V_j = 1.0 / j.rho;
        const Tile change = (V_i - V_j) / r;
        const Tile slope_i = straight ? change : -dot(i.drho_dx, n) * V_i * V_i;
        const Tile slope_j = straight ? change : -dot(j.drho_dx, n) * V_j * V_j;
        return volumes_detail::of_both_h(i, j, r, kernel, CubicAlong{V_i, V_j, slope_i, slope_j, r});
    }
};

/// ln V(s) and ln h(s) interpolated, and the integral (77) itself, where (79) has two halves that each take h
/// as even. With L = ln V, h ~ V^(1/d) and h'' the second derivative of h along the line, to first order in
/// it,
///     area = <V^2> {2 (1 + nu h h''/2) dW_2/dr + W_2/h [2 r s/(nu h^2) h' + r h'']},   h = h(0) + nu h^2/4
///     h'',   <V^2> = V(0)^2 (1 + <s^2> (L'' + 2 L'^2)),   s = 2 <s^2> L',
/// W_2 the wide kernel at this h, nu h^2 the variance of W. V(0) is the geometric mean of both V but for a
/// curvature: between particles of very different densities it does not follow the larger V. L'^2 fades where
/// V changes by more than a factor of e, and the curvature is at most twice what the change itself explains.
struct GeometricVolume {
    using Reads = CubicVolume::Reads;
    using Slopes = CubicVolume::Slopes;
    static constexpr double little = 1e-2;  ///< change of ln V below which slopes may disagree
    // [face]
    template <int d>
    Between face(const auto& i, const auto& j, const Vec<Tile, d>& n, const Tile& r,
                 const auto& kernel) const {
        const double nu = kernel.variance;
        const Tile slope_i = -dot(i.drho_dx, n) / i.rho, slope_j = -dot(j.drho_dx, n) / j.rho;
        const Tile V2_mean = 1.0 / (i.rho * j.rho), change = (j.rho - i.rho) * V2_mean.sqrt() / r;
        const auto agree = slope_i * slope_j >= -(little * little) / (r * r);
        const Tile most = (2.0 * change.abs() + little / r) / r;
        const Tile curve = agree.select((slope_i - slope_j) / r, 0.0).min(most).max(-most);  // L''
        const Tile slope = agree.select(1.5 * change - 0.25 * (slope_i + slope_j), change);  // L'
        const Tile steep = slope * slope / (1.0 + (slope * r).square());
        const Tile fall = (-0.125 / d * curve * r * r).exp(), bent = curve / d + steep / (d * d);  // h''/h
        const Tile h_i = i.h, h_j = j.h, half_way = (h_i * h_j).sqrt() * fall;
        const Tile h =
            (half_way * (1.0 + 0.25 * nu * half_way * half_way * bent)).max(h_i.min(h_j)).min(h_i.max(h_j));
        const Tile s2 = kernel.product * h * h, s = (2.0 * s2 * slope).max(-0.25 * r).min(0.25 * r);
        const Tile V2 = V2_mean * to_dimension(d, fall * fall) * (1.0 + s2 * (curve + 2.0 * steep)).max(0.25);
        const Tile from_W = 2.0 * (1.0 + 0.5 * nu * h * h * bent) * r * kernel.wide_F(r, h);
        const Tile from_h = kernel.wide_W(r, h) * (2.0 * r * s / (nu * h * h) * slope / d + r * bent);
        return {V2 * (from_W + from_h).min(0.0), s};
    }
    // [end]
};

}  // namespace sph
