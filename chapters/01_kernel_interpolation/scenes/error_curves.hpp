#pragma once
#include "chapters/01_kernel_interpolation/scenes/options.hpp"

/// How errors change with the number of particles.
namespace sph::interpolation {

/// Particles of one kind, in any number.
struct ParticleSeries {
    std::string name, label, plain;  // in results, in figures, in tables
    Arrangement arrangement;
    bool growing_h = false;  // h shrinks like sqrt(dx), so that the number of neighbours grows
    plot::Marker marker = plot::Marker::none;
};
const std::vector<ParticleSeries>& particle_series();

/// Relative L2 errors of the test function's estimates against the number of particles along a side.
struct ErrorCurves {
    plot::Values n, value, gradient, laplacian, twice;
};
/// d = 1, 2, 3. Disordered particles: root mean square over a few sets, for a smooth curve.
template <int d>
ErrorCurves error_curves(const ParticleSeries& series, const SmoothingOptions& options,
                         const report::Run& run);
extern template ErrorCurves error_curves<1>(const ParticleSeries&, const SmoothingOptions&,
                                            const report::Run&);
extern template ErrorCurves error_curves<2>(const ParticleSeries&, const SmoothingOptions&,
                                            const report::Run&);
extern template ErrorCurves error_curves<3>(const ParticleSeries&, const SmoothingOptions&,
                                            const report::Run&);

}  // namespace sph::interpolation
