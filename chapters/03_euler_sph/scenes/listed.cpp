#include "chapters/03_euler_sph/scenes/listed.hpp"

#include "chapters/03_euler_sph/resolution.hpp"

namespace sph::euler {

std::vector<std::pair<std::string, report::ListedPass>> listed_passes() {
    using K = AnyKernel<2>;
    constexpr double h_over_dx = 1.3;
    const K cubic{"cubic"};
    const ConstantH<K> one{h_over_dx / 64, cubic};
    const OwnH<K> own{cubic};
    const BothH<K> both{cubic};
    std::vector<std::pair<std::string, report::ListedPass>> passes;
    const auto list = [&](const char* label, const auto& smoothing, const auto&... effects) {
        passes.emplace_back(label, listed_in_square(h_over_dx, smoothing, effects...));
    };
    list("density", one, SummedDensity{});
    list("density and its slope with own h", own, SummedDensity{}, DensitySlope{});
    list("pressure (3.7)", one, PressureForce<>{});
    list("pressure (3.7) and linear force", one, PressureForce<>{}, LinearForce{1});
    list("pressure (3.16)", one, PressureForce<PhiIsOne>{});
    list("pressure (3.17)", one, PressureForce<PhiIsRootPressure>{});
    list("pressure (3.7) and heating", one, PressureForce<>{}, CompressionHeating<>{});
    list("pressure (3.7) with heating and work", one, PressureForce<>{}, CompressionHeating<>{}, Work{});
    list("pressure (3.23) with both h", both, GradHForce{});
    list("pressure (3.23) and heating", both, GradHForce{}, GradHHeating{});
    return passes;
}

}  // namespace sph::euler
