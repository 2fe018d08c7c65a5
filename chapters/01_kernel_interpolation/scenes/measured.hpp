#pragma once
#include <string>
#include <vector>

#include "common/core/arrangement.hpp"

/// Interpolations of the test function on particles of the periodic unit box, and their errors: what several
/// figures measure. Compiled once for all kernels.
namespace sph::interpolation {

/// One interpolation. `kernel` is one of any_kernel_names(); h_over_dx > 0; jitter in spacings, for jittered
/// particles.
struct Setting {
    std::string kernel = "cubic";
    Arrangement arrangement = Arrangement::even;
    std::size_t per_side = 32;
    double h_over_dx = 1.2;
    double jitter = 0.2;
    std::uint64_t seed = 1;
    int threads = 1;  // of the estimates; results do not depend on it

    double h() const { return h_over_dx / static_cast<double>(per_side); }
};

/// Every estimate of interpolation.hpp but the tensor, at every particle.
template <int d>
struct Estimates {
    std::vector<Vector<d>> x;
    std::vector<double> value;                         // (2.8)
    std::vector<Vector<d>> plain, gradient, weighted;  // (2.11), (2.14), (2.15)
    std::vector<double> twice, laplacian;              // (2.21), (2.24)
};
/// d = 1, 2, 3. Throws std::invalid_argument for an unknown kernel.
template <int d>
Estimates<d> estimates_at_particles(const Setting& setting);
extern template Estimates<1> estimates_at_particles<1>(const Setting&);
extern template Estimates<2> estimates_at_particles<2>(const Setting&);
extern template Estimates<3> estimates_at_particles<3>(const Setting&);

/// Relative L2 errors over all particles against the test function.
struct Errors {
    double value = 0, plain = 0, gradient = 0, weighted = 0, twice = 0, laplacian = 0;
};
template <int d>
Errors errors_of(const Estimates<d>& estimates);
template <int d>
Errors errors_of(const Setting& setting) {
    return errors_of(estimates_at_particles<d>(setting));
}
extern template Errors errors_of<1>(const Estimates<1>&);
extern template Errors errors_of<2>(const Estimates<2>&);
extern template Errors errors_of<3>(const Estimates<3>&);

/// The value (2.8) at any positions in the box, and the particles it comes from.
struct Map {
    std::vector<double> value;
    Columns<2> particles;
};
Map interpolate_at(const Setting& setting, const Columns<2>& positions);

}  // namespace sph::interpolation
