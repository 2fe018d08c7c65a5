#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "chapters/04_artificial_viscosity/viscosities.hpp"
#include "chapters/07_godunov_sph/godunov_gas.hpp"
#include "chapters/07_godunov_sph/scenes/open_gas.hpp"
#include "common/plot/method_looks.hpp"

namespace sph::godunov {
namespace {

constexpr double close_enough = 1e-4;       // energy hangs on the work of pairs, not on h
using InChannel = ConvolvedGaussian<2, 3>;  // 3 sqrt2 h, where exp(-9) is left of the force

// [methods]
using ThirdOrderFlow = Godunov<ThirdOrder, CubicVolume, HllcRiemann, ClosingRate>;
using GeometricFlow = Godunov<ThirdOrder, GeometricVolume, HllcRiemann, ClosingRate>;
using FirstOrderFlow = Godunov<ConstantSides, CubicVolume, HllcRiemann, ClosingRate>;
using PaperFlow = Godunov<PaperConstraint, CubicVolume, ExactRiemann, SoundRate>;
using ViscousFlow = Dissipation<AlphaBeta>;
// [end]

ChannelMethod described_flow(const char* name, const char* look, const char* label) {
    return {name, label, plot::look_of(look), "gaussian", 1.0};
}
/// The paper's C_smooth is 1 here, so that h follows the density itself.
template <class Scheme>
ChannelMethod solving_flow(ChannelMethod method, const Scheme& scheme) {
    method.parameters = parameters_of(scheme);
    method.build = [scheme](const ChannelMethod& chosen,
                            const ChannelSetup& setup) -> std::unique_ptr<OpenGas> {
        using Gas = GodunovGas<ConsistentH<InChannel>, Scheme, OpenChannel>;
        return std::make_unique<Opened<Gas>>(
            setup.n, ConsistentH<InChannel>{HRule{chosen.h_over_dx}, close_enough}, setup.state,
            with_parameters(scheme, chosen.parameters), setup.channel, setup.courant, setup.threads);
    };
    return method;
}
template <class Scheme>
Scheme as_in_paper(Scheme scheme = {}) {
    scheme.retries = false;
    return scheme;
}
PaperFlow of_straight_flow() {
    PaperFlow scheme;
    scheme.volumes.straight = true;
    return scheme;
}
ChannelMethod open_markers(ChannelMethod method) {
    method.look.filled = false;
    return method;
}
/// Chapter 4's gas, its kernel and its h.
ChannelMethod viscous_flow(const char* name, const char* label, double alpha) {
    ChannelMethod method = described_flow(name, "alpha-beta", label);
    const ViscousFlow scheme{{.alpha = alpha, .beta = 2 * alpha}};
    method.kernel = "wendland-c4", method.h_over_dx = 1.6;
    method.parameters = parameters_of(scheme);
    method.build = [scheme](const ChannelMethod& chosen,
                            const ChannelSetup& setup) -> std::unique_ptr<OpenGas> {
        using Resolution = ConsistentH<AnyKernel<2>>;
        return std::make_unique<Opened<DissipativeGas<Resolution, ViscousFlow, OpenChannel>>>(
            setup.n, Resolution{HRule{chosen.h_over_dx}, close_enough, AnyKernel<2>{chosen.kernel}},
            setup.state, with_parameters(scheme, chosen.parameters), setup.channel, setup.courant,
            setup.threads);
    };
    return method;
}

}  // namespace

const ChannelMethods& channel_methods() {
    static const ChannelMethods methods{
        "godunov",
        {solving_flow(described_flow("inutsuka", "inutsuka", "Inutsuka 2002"), as_in_paper<PaperFlow>()),
         solving_flow(open_markers(described_flow("inutsuka-linear", "inutsuka", "Inutsuka 2002, linear")),
                      as_in_paper(of_straight_flow())),
         solving_flow(described_flow("first-order", "limited", "Godunov SPH, first order"), FirstOrderFlow{}),
         solving_flow(described_flow("godunov", "godunov", "Godunov SPH"), ThirdOrderFlow{}),
         solving_flow(described_flow("geometric-volume", "own-width", "Godunov SPH with (7.16)"),
                      GeometricFlow{}),
         viscous_flow("alpha-beta", "α = 1, β = 2", 1),
         open_markers(viscous_flow("alpha-beta-twice", "α = 2, β = 4", 2))}};
    return methods;
}

}  // namespace sph::godunov
