#pragma once
#include <vector>

#include "chapters/01_kernel_interpolation/scenes/measured.hpp"

/// The two errors of a sum, each by itself: smoothing, which the integral makes, and sampling, which the sum
/// adds.
namespace sph::interpolation {

/// One bump of the sum (2.8) for each particle on the periodic unit line: V_j A_j W(x - x_j), h > 0.
struct Bumps {
    std::vector<double> x, A;  // of the particles
    double h = 0, V = 0;       // V = dx: particles of equal volume
    /// The bump of particle j at a place; the next of its periodic images counts.
    double of(std::size_t j, double place) const;
    double sum(double place) const;
};
/// `n` particles shifted at random by up to `jitter` spacings, A = the test function, cubic spline, h in
/// spacings.
Bumps bumps(std::size_t n, double h_over_dx, double jitter, std::uint64_t seed);

/// Relative L2 errors of the wave A = cos 2 pi x and of the constant 1 on the particles of a Setting in 1D,
/// cubic spline, all with rho = 1: root mean square over four sets where the particles are disordered.
struct WaveErrors {
    double smoothing = 0;  // |W^(k h) - 1|, of the integral
    double sampling = 0;   // even: |sum over r <> 0 of W^((k + 2 pi r/dx) h)|; else the error of a constant
    double measured = 0;   // of the sum over particles
};
WaveErrors wave_errors(const Setting& setting);

}  // namespace sph::interpolation
