#include "chapters/04_artificial_viscosity/scenes/listed.hpp"

#include "chapters/04_artificial_viscosity/switches.hpp"

namespace sph::shocks {

std::vector<std::pair<std::string, report::ListedPass>> listed_passes() {
    using Sheared = Scaled<SignalViscosity, ShearFactor>;
    const GradHForce force;
    const SignalRate limit;
    const GradHHeating heat;
    const BothH<AnyKernel<2>> both{AnyKernel<2>{"cubic"}};
    std::vector<std::pair<std::string, report::ListedPass>> passes;
    const auto list = [&](const char* label, const auto&... effects) {
        passes.emplace_back(label, euler::listed_in_square(1.2, both, effects...));
    };
    list("pressure", force);
    list("pressure and limit of the time step", force, limit);
    list("these and α-β viscosity", force, limit, ViscousForce<AlphaBeta>{});
    list("these and signal viscosity", force, limit, ViscousForce<SignalViscosity>{});
    list("these and signal viscosity with own factor", force, limit, ViscousForce<Sheared>{});
    list("these and reconstructed viscosity", force, limit, ViscousForce<ReconstructedViscosity>{});
    list("pressure heating", heat);
    list("pressure and α-β heating", heat, ViscousHeating<AlphaBeta>{});
    list("pressure and reconstructed heating", heat, ViscousHeating<ReconstructedViscosity>{});
    list("the same and conduction", heat, ViscousHeating<ReconstructedViscosity>{},
         Conduction<ContactSpeed>{});
    list("gradient of $v$", VelocityGradient{});
    list("gradients of $v$ and $P$", VelocityGradient{}, PressureGradient{});
    return passes;
}

}  // namespace sph::shocks
