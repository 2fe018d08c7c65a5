#pragma once

namespace exact {

/// Gresho's vortex: a fluid of even density that turns around the origin and stays as it is, since the
/// pressure holds it. With s = r/R, R where it turns fastest,
///     v = V s,         p = p_0 + rho V^2 s^2/2                        for s <= 1,
///     v = V (2 - s),   p = p_0 + rho V^2 (s^2/2 + 4 - 4 s + 4 ln s)   for 1 <= s <= 2,
///     v = 0,           p = p_0 + rho V^2 (4 ln 2 - 2)                 farther out.
/// It solves the Euler equations of any fluid: dp/dr = rho v^2/r, and nothing is compressed.
/// Source: Gresho & Chan, Int. J. Numer. Meth. Fluids 11 (1990) 621, section 4; with a pressure p_0 for
/// gases: Liska & Wendroff, SIAM J. Sci. Comput. 25 (2003) 995, whose case is V = 1, R = 0.2, rho = 1, p_0
/// = 5.
///
/// Units: of length, time and mass as the caller likes. Accuracy: rounding, 1e-15 of V and of p_0 + rho V^2.
class Gresho {
  public:
    static constexpr double least_scale = 1e-50, largest_scale = 1e50;

    /// speed V [length/time], the largest one, radius R [length], density [mass/length^2] in
    /// least_scale..largest_scale; pressure p_0 at the centre, 0..largest_scale.
    /// Throws std::domain_error, which names the value, outside these ranges.
    Gresho(double speed, double radius, double density, double pressure);

    struct State {
        double v, p;  ///< around the origin, counter-clockwise
    };
    /// At the distance r >= 0, finite, at any time. Throws std::domain_error, which names the value, for
    /// others.
    State at(double r) const;

  private:
    double speed_, radius_, density_, pressure_;
};

}  // namespace exact
