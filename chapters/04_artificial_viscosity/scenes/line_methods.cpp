#include "chapters/04_artificial_viscosity/scenes/dissipating.hpp"

namespace sph::shocks {
namespace {

using Bulk = Dissipation<BulkPressure, NoConduction, BulkDetector>;
using Thermokinetic = Dissipation<SignalViscosity, Conduction<SignalSpeed>>;
using Own = Scaled<SignalViscosity, ViscosityAlpha>;
using Switched = Dissipation<Own, NoConduction, MorrisMonaghan>;
using Price = Dissipation<Own, Conduction<OwnSpeed>, PriceSwitch>;
using Reconstructed = Dissipation<ReconstructedViscosity, Conduction<ContactSpeed>, FlowSlopes>;

/// With the cubic spline, h = 1.2 spacings.
template <class Scheme>
Method<1> cubic(const char* name, const char* label, std::size_t colour, plot::Marker marker,
                const Scheme& scheme) {
    return dissipating<1>({name, label, {.colour = plot::cycle(colour), .marker = marker}, "cubic", 1.2},
                          scheme);
}
template <class Scheme>
Method<1> quadratic(const char* name, const char* label, std::size_t colour, plot::Marker marker,
                    const Scheme& scheme) {
    return dissipating<1>({name, label, {.colour = plot::cycle(colour), .marker = marker}, "quadratic", 1.0},
                          scheme);
}

}  // namespace

const Methods<1>& tube_methods() {
    using plot::Marker;
    static const Methods<1> methods{
        "reconstructed",
        {cubic("none", "no viscosity", 7, Marker::plus, Dissipation<NoViscosity>{}),
         cubic("von-neumann", "von Neumann–Richtmyer", 6, Marker::triangle_down, Bulk{}),
         cubic("bulk", "bulk viscosity", 5, Marker::triangle_up, Bulk{{}, {}, {.a = 0, .b = 1}}),
         cubic("monaghan-gingold", "Monaghan–Gingold 1983", 3, Marker::diamond,
               Dissipation<AlphaBeta>{{.beta = 0}}),
         cubic("alpha-beta", "α = 1, β = 2", 1, Marker::square, Dissipation<AlphaBeta>{}),
         cubic("signal", "signal velocity", 4, Marker::triangle_up, Dissipation<SignalViscosity>{}),
         cubic("thermokinetic", "thermokinetic", 2, Marker::square, Thermokinetic{}),
         cubic("morris-monaghan", "Morris–Monaghan", 5, Marker::diamond, Switched{}),
         cubic("price", "Price", 3, Marker::triangle_down, Price{}),
         quadratic("narrow", "signal velocity, narrow kernel", 1, Marker::cross,
                   Dissipation<SignalViscosity>{{.K = 0.85}}),
         quadratic("reconstructed", "reconstructed", 0, Marker::circle, Reconstructed{})}};
    return methods;
}

const Methods<1>& kernel_methods() {
    const auto of_1983 = [](const char* name, const char* label, plot::Style look, const char* kernel,
                            double h) {
        look.filled = false;
        return dissipating<1>({name, label, look, kernel, h}, Dissipation<AlphaBeta>{{.beta = 0}});
    };
    using plot::Marker;
    static const Methods<1> methods{
        "mg-super-gaussian",
        {of_1983("mg-gaussian", "Gaussian", {.colour = plot::cycle(0), .marker = Marker::circle}, "gaussian",
                 1.0),
         of_1983("mg-super-gaussian", "super-Gaussian", {.colour = plot::cycle(1), .marker = Marker::cross},
                 "super-gaussian", 1.35),
         of_1983("monaghan-gingold", "cubic spline", {.colour = plot::cycle(2), .marker = Marker::square},
                 "cubic", 1.2)}};
    return methods;
}

}  // namespace sph::shocks
