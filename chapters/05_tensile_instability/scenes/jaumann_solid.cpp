#include "chapters/05_tensile_instability/scenes/jaumann_solid.hpp"

#include "chapters/05_tensile_instability/scenes/solid_laws.hpp"

namespace sph::tensile {
namespace {

// [laws]
template <class Rate>
Effects<JaumannRate<Rate>> hooke(const Elastic& matter) {
    return Effects{JaumannRate<Rate>{matter.shear}};
}
auto forces(const SolidSetup& setup) {
    return Effects{StressForce{}, ViscousForce<AlphaBeta>{{.alpha = setup.alpha, .beta = 0}}};
}
auto forces_with_artificial_stress(const SolidSetup& setup, const ConstantH<SolidKernel>& smoothing) {
    return Effects{StressForce{}, ViscousForce<AlphaBeta>{{.alpha = setup.alpha, .beta = 0}},
                   ArtificialStressForce{smoothing.kernel.W(setup.dx, smoothing.h)}};
}
// [end]

template <class Boundary>
std::unique_ptr<Solid> solid_in(const Boundary& boundary, const SolidSetup& setup,
                                const SolidMethod& method) {
    const ConstantH<SolidKernel> smoothing = smoothing_of(setup, method);
    const auto make = [&](const auto& strains, const auto& forces) -> std::unique_ptr<Solid> {
        return std::make_unique<
            JaumannSolid<std::decay_t<decltype(strains)>, std::decay_t<decltype(forces)>, Boundary>>(
            setup, smoothing, boundary, strains, forces);
    };
    const auto printed = hooke<SummedRate>(setup.matter);
    if (method.law == Law::artificial_stress)
        return make(printed, forces_with_artificial_stress(setup, smoothing));
    if (method.law == Law::xsph)
        return make(Effects{JaumannRate<SummedRate>{setup.matter.shear}, Xsph{1}}, forces(setup));
    if (method.law == Law::corrected_rate) return make(hooke<CorrectedRate>(setup.matter), forces(setup));
    return make(printed, forces(setup));
}

}  // namespace

std::unique_ptr<Solid> make_jaumann_solid(const SolidSetup& setup, const SolidMethod& method) {
    return setup.box ? solid_in(*setup.box, setup, method) : solid_in(Free{}, setup, method);
}

}  // namespace sph::tensile
