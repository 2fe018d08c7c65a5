#pragma once
#include "common/core/simulation.hpp"

/// What both kinds of solids sum over their particles.
namespace sph::tensile {

/// sum m, sum m v, sum m v^2/2
template <class P>
Totals<2> totals_of_motion(const P& particles) {
    Totals<2> sum;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const auto v = load<2>(particles, i, List<Velocity>{}).v;
        sum.mass += particles.m[i];
        sum.momentum += particles.m[i] * v;
        sum.energy += 0.5 * particles.m[i] * dot(v, v);
    }
    return sum;
}

}  // namespace sph::tensile
