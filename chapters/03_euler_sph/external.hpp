#pragma once
#include "common/core/effects.hpp"

/// What acts on particles one by one. Only scenes that list these have them.
namespace sph {

/// dv_i/dt = - Omega^2 x_i: the attraction of all particles, in proportion to their distance, seen from their
/// common centre   (Monaghan 2005, 6.14-6.16)
struct LinearForce {
    double Omega;
    using ReadsI = List<Position>;
    using Writes = List<Acceleration>;
    void finish(const auto& i, const auto&, auto& out) const { out.dv_dt -= (Omega * Omega) * i.x; }
    /// Potential energy by mass.
    template <int d>
    double potential(const Vector<d>& x) const {
        return 0.5 * Omega * Omega * dot(x, x);
    }
};

/// dv_i/dt = - nu v_i: friction that lets a star come to rest   (2.45). nu >= 0 [1/T]
struct Damping {
    double nu;
    using ReadsI = List<Velocity>;
    using Writes = List<Acceleration>;
    void finish(const auto& i, const auto&, auto& out) const { out.dv_dt -= nu * i.v; }
};

}  // namespace sph
