#pragma once
#include <algorithm>

#include "chapters/01_kernel_interpolation/interpolation.hpp"
#include "chapters/02_consistency/scenes/measured.hpp"

namespace sph::consistency {

/// Particles that end where they end, with the listed estimates. Used by .cpp files: what is listed is
/// compiled.
template <int d, class... Listed>
using Cloud = InterpolationWithin<AnyKernel<d>, Free, Listed...>;

/// The particles that `set` describes.
template <int d, class... Listed>
Cloud<d, Listed...> cloud_of(const ParticleSet& set, const Function<d>& function) {
    return Cloud<d, Listed...>{
        Free{},      set.points<d>(),         set.h(), function.value, set.volumes == Volumes::summed,
        set.threads, AnyKernel<d>{set.kernel}};
}

/// Whether neither the particle's kernel nor those of its neighbours, on which their volumes depend, reach an
/// end.
template <int d>
bool is_inside(const Vector<d>& x, double reach) {
    return std::all_of(x.begin(), x.end(), [&](double c) { return c > 2 * reach && c < 1 - 2 * reach; });
}

}  // namespace sph::consistency
