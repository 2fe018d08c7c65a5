#include "chapters/05_tensile_instability/scenes/listed.hpp"

#include "chapters/05_tensile_instability/cures.hpp"
#include "chapters/05_tensile_instability/total_lagrangian.hpp"

namespace sph::tensile {

std::vector<std::pair<std::string, report::ListedPass>> listed_passes() {
    using K = CubicSpline<2>;
    constexpr double h_over_dx = 1.2;
    const ConstantH<K> one{h_over_dx / 64};
    const PressureForce<> pressure;
    const JaumannRate<SummedRate> hooke{0.22};
    const JaumannRate<CorrectedRate> corrected{0.22};
    const StressForce stress;
    std::vector<std::pair<std::string, report::ListedPass>> passes;
    const auto list = [&](const char* label, const auto&... effects) {
        passes.emplace_back(label, euler::listed_in_square(h_over_dx, one, effects...));
    };
    list("pressure (5.2)", pressure);
    list("pressure and artificial stress", pressure, ArtificialPressure{});
    list("pressure and XSPH", pressure, Xsph{0.5});
    list("pressure and transport stress", pressure, TransportStress{});
    list("pressure and background", pressure, BackgroundForce{});
    list("Hooke's law (5.9)", hooke);
    list("Hooke's law with corrected gradients", corrected);
    list("stress (5.10)", stress);
    list("stress and artificial stress (5.15)", stress, ArtificialStressForce{1});
    list("deformation and energy (5.12) (5.14)", NeoHookean{{1, 0.22, 1}});
    list("reference force (5.13)", ReferenceForce{});
    return passes;
}

}  // namespace sph::tensile
