#include "chapters/09_transverse_expansion/scenes/listed.hpp"

#include "chapters/03_euler_sph/scenes/listed.hpp"
#include "chapters/09_transverse_expansion/corrected_force.hpp"

namespace sph::transverse {

std::vector<std::pair<std::string, report::ListedPass>> listed_passes() {
    using K = AnyKernel<2>;
    using Of = OfCurvedEntropy;
    constexpr double h_over_dx = 1.8;
    const K wendland{"wendland-c4"};
    std::vector<std::pair<std::string, report::ListedPass>> passes;
    const auto list = [&](const char* label, const auto& smoothing, const auto&... effects) {
        passes.emplace_back(label, euler::listed_in_square(h_over_dx, smoothing, effects...));
    };
    list("density", ConstantH<K>{h_over_dx / 64, wendland}, Of::Counted<SummedDensity>{});
    list("density and its slope with own h", OwnH<K>{wendland}, Of::Counted<SummedDensity>{},
         Of::Counted<DensitySlope>{});
    list("force with one h", ConstantH<K>{h_over_dx / 64, wendland}, Of::Counted<PressureForce<>>{});
    list("force with both h", BothH<K>{wendland}, Of::Counted<PressureForce<>>{});
    list("force with grad-h terms", BothH<K>{wendland}, Of::Counted<GradHForce>{});
    list("corrected gradient", BothH<K>{wendland}, CorrectedForce{});
    return passes;
}

}  // namespace sph::transverse
