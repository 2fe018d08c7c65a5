#include "chapters/07_godunov_sph/scenes/listed.hpp"

#include "chapters/07_godunov_sph/godunov_force.hpp"

namespace sph::godunov {

std::vector<std::pair<std::string, report::ListedPass>> listed_passes() {
    using K = ConvolvedGaussian<2, 3>;
    const BothH<K> both{};
    const StepOfSides step{1e-3, 1.4, K::bend, K::reach2};
    std::vector<std::pair<std::string, report::ListedPass>> passes;
    const auto list = [&](const char* label, const auto&... effects) {
        passes.emplace_back(label, euler::listed_in_square(1.0, both, effects...));
    };
    list("gradients and limit of the time step", FlowGradient{}, FittedDensitySlope{}, PressureGradient{},
         ClosingRate{});
    list("HLLC of first order", RiemannForce<ConstantSides, CubicVolume, HllcRiemann, K>{{}, {}, {}, step});
    list("HLLC of third order", RiemannForce<ThirdOrder, CubicVolume, HllcRiemann, K>{{}, {}, {}, step});
    list("two shocks of third order", RiemannForce<ThirdOrder, CubicVolume, TwoShock, K>{{}, {}, {}, step});
    list("exact solver of third order",
         RiemannForce<ThirdOrder, CubicVolume, ExactRiemann, K>{{}, {}, {}, step});
    return passes;
}

}  // namespace sph::godunov
