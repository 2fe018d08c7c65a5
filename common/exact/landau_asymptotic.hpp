#pragma once

namespace exact {

/// What Landau's slab is said to become, p = c0^2 eps with c0^2 = 1/3 and l = 1:
///     rapidity = ln[(t + x)/(t - x)]/2,   Delta = sqrt((1 - c0^2)/pi) l,
///     ln T = -(1 + c0^2)/4 L + (1 - c0^2)/4 sqrt(L^2 - M^2),
///     L = ln[(t^2 - x^2)/Delta^2],   M = ln[(t + x)/(t - x)],
/// and, where the rapidity is small beside L, ln T = -c0^2/2 L, which is Bjorken's flow.
/// Source: Chen (2017), eqs 244-250. Its 281 takes this as the temperature inside the cylinder's head; a
/// cylinder that begins with one temperature at tau0 has tau0 in the place of Delta (transverse.hpp).
///
/// It is no limit of the slab (landau.hpp): at x = 0 the slab's ln T is -1.002, -1.894, -4.338 at t = 10,
/// 100, 1e5, and this one's is -1.026, -1.793, -4.096. They cross near t = 15 and drift apart as ln|ln T|/6
/// from there on: the slab comes near to Bjorken's flow only as a logarithm does.
struct LandauAsymptotics {
    double t;  ///< above 0, finite, in units of the slab's half width

    struct State {
        double rapidity, log_temperature;
        double log_bjorken;  ///< ln T for small rapidities
    };
    static double delta();  ///< sqrt(2/(3 pi)) = 0.4607
    /// If the formula has a value at x: |x| <= t - Delta, where L >= |M|.
    bool holds(double x) const;
    /// At x, where it holds. Throws std::domain_error, which names the value, elsewhere.
    State at(double x) const;
};

}  // namespace exact
