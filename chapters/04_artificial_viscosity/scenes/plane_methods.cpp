#include "chapters/04_artificial_viscosity/physical_viscosity.hpp"
#include "chapters/04_artificial_viscosity/scenes/dissipating.hpp"
#include "common/plot/method_looks.hpp"

namespace sph::shocks {
namespace {

using Sheared = Scaled<SignalViscosity, ShearFactor>;
using Reconstructed = Dissipation<ReconstructedViscosity, Conduction<ContactSpeed>, FlowSlopes>;
using Pairwise = Dissipation<PairwiseViscosity>;
using Layered = Dissipation<LayeredViscosity, NoConduction, GivenViscosity>;
using Stress = Dissipation<StressViscosity, NoConduction, StressDetector>;

/// Why Wendland C4, and why h = 1.6 spacings: with the cubic spline and 1.2 spacings a lattice that is
/// sheared buckles, and takes from the shear, at first, what a viscosity of 0.05 c_s h would; in shocks both
/// are equally good. Real viscosities need 2.6: at 2 spacings the order of the particles resists vortices
/// by tens of per cent of what viscosity does. (Measured: README, "A shear layer" and "Real viscosity".)
constexpr double narrow = 1.6, wide = 2.6;

template <class Scheme>
Method<2> wendland(const char* name, const char* label, const Scheme& scheme, double h_over_dx = narrow) {
    return dissipating<2>({name, label, plot::look_of(name), "wendland-c4", h_over_dx}, scheme);
}
template <class Scheme>
Method<2> cubic(const char* name, const char* label, const Scheme& scheme) {
    return dissipating<2>({name, label, plot::look_of(name), "cubic", 1.2}, scheme);
}

}  // namespace

const Methods<2>& plane_methods() {
    static const Methods<2> methods{
        "reconstructed",
        {cubic("none-cubic", "no viscosity, cubic spline", Dissipation<NoViscosity>{}),
         cubic("signal-cubic", "signal velocity, cubic spline", Dissipation<SignalViscosity>{}),
         wendland("none", "no viscosity", Dissipation<NoViscosity>{}),
         wendland("alpha-beta", "α = 1, β = 2", Dissipation<AlphaBeta>{}),
         wendland("signal", "signal velocity", Dissipation<SignalViscosity>{}),
         wendland("balsara", "Balsara", Dissipation<Sheared, NoConduction, Balsara>{}),
         wendland("colagrossi", "Colagrossi", Dissipation<Sheared, NoConduction, Colagrossi>{}),
         wendland("reconstructed", "reconstructed", Reconstructed{})}};
    return methods;
}

const Methods<2>& viscous_methods() {
    static const Methods<2> methods{"pairwise",
                                    {wendland("pairwise", "pairwise (8.9)", Pairwise{}, wide),
                                     wendland("stress", "stress", Stress{}, wide)}};
    return methods;
}

const Methods<2>& layered_methods() {
    static const Methods<2> methods{"layered",
                                    {wendland("layered", "harmonic mean (8.9)", Layered{}, wide),
                                     wendland("layered-arithmetic", "arithmetic mean",
                                              Layered{{.mean = MeanViscosity::arithmetic}}, wide)}};
    return methods;
}

}  // namespace sph::shocks
