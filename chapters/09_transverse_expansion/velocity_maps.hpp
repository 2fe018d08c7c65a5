#pragma once
#include <cmath>

#include "common/core/vec.hpp"

/// A velocity seen from the laboratory (t, x, y, z) and from hyperbolic coordinates (tau, x, y, eta),
/// t = tau cosh eta, z = tau sinh eta.
namespace sph {

// [maps]
/// dx/dtau, dy/dtau, deta/dtau of what has the velocity v = dx/dt in the laboratory, |v| < 1, at tau > 0 and
/// eta   (Chen 2017, 341-343). The denominator is gamma'/gamma (340).
inline Vector<3> to_hyperbolic(const Vector<3>& v, double tau, double eta) {
    const double ch = std::cosh(eta), sh = std::sinh(eta), ratio = ch - sh * v[2];
    return {v[0] / ratio, v[1] / ratio, (ch * v[2] - sh) / (tau * ratio)};
}
/// And back   (346 for v_z; for v_x and v_y the inverse of 341, 342).
inline Vector<3> to_laboratory(const Vector<3>& v, double tau, double eta) {
    const double ch = std::cosh(eta), sh = std::sinh(eta), ratio = ch + sh * tau * v[2];
    return {v[0] / ratio, v[1] / ratio, (sh + ch * tau * v[2]) / ratio};
}
// [end]

}  // namespace sph
