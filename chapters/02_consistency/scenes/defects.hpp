#pragma once
#include "chapters/02_consistency/scenes/measured.hpp"

/// How wrong the moments of sums are, inside and at an end.
namespace sph::consistency {

/// Moments of the particles' sums: rms of m0 - 1 and of |m1|/h, and the mean of m2/h^2 per axis over that of
/// the kernel, minus 1. Over particles inside; `kernel` one of kernel_names().
struct MomentDefects {
    double m0 = 0, m1 = 0, m2 = 0;
};
template <int d>
MomentDefects moment_defects(const ParticleSet& set);
extern template MomentDefects moment_defects<1>(const ParticleSet&);
extern template MomentDefects moment_defects<2>(const ParticleSet&);

/// m0 and the component of m1/h away from the end, at particles at each distance from the end x = 0 (in 2D
/// along the middle of the edge); even particles.
struct AtTheEnd {
    Column distance_over_h, m0, m1;
};
template <int d>
AtTheEnd moments_at_the_end(const ParticleSet& set);
extern template AtTheEnd moments_at_the_end<1>(const ParticleSet&);
extern template AtTheEnd moments_at_the_end<2>(const ParticleSet&);

/// The same for the integral instead of the sum, at distance s h from the end: m0 = integral of W over what
/// is left, m1/h the integral of W x/h (Chen 2017, 82 and 86). Throws std::invalid_argument for a kernel that
/// is none of kernel_names().
struct KernelAtTheEnd {
    double m0 = 0, m1 = 0;
};
template <int d>
KernelAtTheEnd integrals_at_the_end(const std::string& kernel, double s);
extern template KernelAtTheEnd integrals_at_the_end<1>(const std::string&, double);
extern template KernelAtTheEnd integrals_at_the_end<2>(const std::string&, double);

}  // namespace sph::consistency
