#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "chapters/01_kernel_interpolation/kernels.hpp"
#include "chapters/03_euler_sph/gas.hpp"

/// The resolutions and kernels of this chapter by name, so that figures, scenes and tests run over them.
namespace sph {

/// A way to run a gas: its resolution, its kernel, and h in spacings (sigma of 4.2).
struct GasScheme {
    std::string resolution = "consistent-h";
    std::string kernel = "cubic";
    double h_over_dx = 1.2;
};

inline const std::vector<std::string>& resolution_names() {
    static const std::vector<std::string> names{"fixed-h", "continuity", "averaged-h", "without-omega",
                                                "consistent-h"};
    return names;
}
/// Those whose forces are functions of the positions, so that there is a star at rest.
inline const std::vector<std::string>& resolutions_at_rest() {
    static const std::vector<std::string> names{"fixed-h", "without-omega", "consistent-h"};
    return names;
}
inline const std::vector<std::string>& dynamic_kernel_names() {
    static const std::vector<std::string> names{"cubic", "quintic", "super-gaussian"};
    return names;
}

/// Calls visit(resolution) for the resolution of that name with the kernel K; dx is the spacing that a fixed
/// h counts in.
template <class K, class Visit>
auto with_resolution(const GasScheme& scheme, double dx, Visit&& visit) {
    const double sigma = scheme.h_over_dx;
    if (scheme.resolution == "fixed-h") return visit(FixedH<K>{sigma * dx});
    if (scheme.resolution == "continuity") return visit(ContinuityH<K, PhiIsDensity>{sigma * dx});
    if (scheme.resolution == "averaged-h") return visit(AveragedH<K>{HRule{sigma}});
    if (scheme.resolution == "without-omega") return visit(WithoutOmega<K>{HRule{sigma}});
    if (scheme.resolution == "consistent-h") return visit(ConsistentH<K>{HRule{sigma}});
    throw std::invalid_argument{"no such resolution: " + scheme.resolution};
}

/// The same in one dimension, with the kernel of that name.
template <class Visit>
auto with_scheme(const GasScheme& scheme, double dx, Visit&& visit) {
    if (scheme.kernel == "cubic") return with_resolution<CubicSpline<1>>(scheme, dx, visit);
    if (scheme.kernel == "quintic") return with_resolution<QuinticSpline<1>>(scheme, dx, visit);
    if (scheme.kernel == "super-gaussian") return with_resolution<SuperGaussian<1>>(scheme, dx, visit);
    throw std::invalid_argument{"no such kernel: " + scheme.kernel};
}

}  // namespace sph
