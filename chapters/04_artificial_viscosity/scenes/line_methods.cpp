#include "chapters/04_artificial_viscosity/scenes/dissipating.hpp"
#include "common/plot/method_looks.hpp"

namespace sph::shocks {
namespace {

// [methods]
using Bulk = Dissipation<BulkPressure, NoConduction, BulkDetector>;
using Thermokinetic = Dissipation<SignalViscosity, Conduction<SignalSpeed>>;
using ThermokineticAll = Dissipation<SignalViscosity, Conduction<SignalSpeedOfAll>>;
using Own = Scaled<SignalViscosity, ViscosityAlpha>;
using Switched = Dissipation<Own, NoConduction, MorrisMonaghan>;
using Price = Dissipation<Own, Conduction<OwnSpeed>, PriceSwitch>;
using Reconstructed = Dissipation<ReconstructedViscosity, Conduction<ContactSpeed>, FlowSlopes>;
// [end]

/// With the cubic spline, h = 1.2 spacings.
template <class Scheme>
Method<1> cubic(const char* name, const char* label, const Scheme& scheme) {
    return dissipating<1>({name, label, plot::look_of(name), "cubic", 1.2}, scheme);
}
template <class Scheme>
Method<1> quadratic(const char* name, const char* label, const Scheme& scheme) {
    return dissipating<1>({name, label, plot::look_of(name), "quadratic", 1.0}, scheme);
}

}  // namespace

const Methods<1>& tube_methods() {
    static const Methods<1> methods{
        "reconstructed",
        {cubic("none", "no viscosity", Dissipation<NoViscosity>{}),
         cubic("von-neumann", "von Neumann–Richtmyer", Bulk{}),
         cubic("bulk", "bulk viscosity", Bulk{{}, {}, {.a = 0, .b = 1}}),
         cubic("monaghan-gingold", "Monaghan–Gingold 1983", Dissipation<AlphaBeta>{{.beta = 0}}),
         cubic("alpha-beta", "α = 1, β = 2", Dissipation<AlphaBeta>{}),
         cubic("beta-alone", "β = 2, no α", Dissipation<AlphaBeta>{{.alpha = 0}}),
         cubic("signal", "signal velocity", Dissipation<SignalViscosity>{}),
         cubic("thermokinetic", "thermokinetic", Thermokinetic{}),
         cubic("thermokinetic-all", "thermokinetic, all pairs", ThermokineticAll{}),
         cubic("morris-monaghan", "Morris–Monaghan", Switched{}), cubic("price", "Price", Price{}),
         quadratic("narrow", "signal velocity, narrow kernel", Dissipation<SignalViscosity>{{.K = 0.85}}),
         quadratic("none-narrow", "no viscosity, narrow kernel", Dissipation<NoViscosity>{}),
         cubic("reconstructed-cubic", "reconstructed, cubic spline", Reconstructed{}),
         quadratic("reconstructed", "reconstructed", Reconstructed{})}};
    return methods;
}

std::vector<Method<1>> tube_contestants() {
    return tube_methods().without(
        {"none", "none-narrow", "beta-alone", "thermokinetic-all", "reconstructed-cubic"});
}

const Methods<1>& kernel_methods() {
    const auto of_1983 = [](const char* name, const char* label, const char* kernel, double h) {
        plot::Style look = plot::look_of(name);
        look.filled = false;
        return dissipating<1>({name, label, look, kernel, h}, Dissipation<AlphaBeta>{{.beta = 0}});
    };
    static const Methods<1> methods{"mg-super-gaussian",
                                    {of_1983("mg-gaussian", "Gaussian", "gaussian", 1.0),
                                     of_1983("mg-super-gaussian", "super-Gaussian", "super-gaussian", 1.35),
                                     of_1983("monaghan-gingold", "cubic spline", "cubic", 1.2)}};
    return methods;
}

}  // namespace sph::shocks
