#include <functional>
#include <stdexcept>

#include "chapters/01_kernel_interpolation/gaussians.hpp"
#include "chapters/01_kernel_interpolation/splines.hpp"
#include "chapters/04_artificial_viscosity/scenes/model_of.hpp"
#include "chapters/04_artificial_viscosity/scenes/quadratic.hpp"

namespace sph {
namespace {

struct Entry {
    Method method;
    std::function<std::unique_ptr<Model<1>>(double h_over_dx, std::size_t, double, const Box<1>&, int)> make;
};

template <template <int> class Kernel, class Scheme>
Entry entry(const char* name, const char* label, double h_over_dx, Scheme scheme) {
    return {{name, label, std::string{Kernel<1>::name}, h_over_dx},
            [scheme](double h, std::size_t n, double gamma, const Box<1>& box, int threads) {
                return std::make_unique<ModelOf<Kernel<1>, Scheme>>(n, h, gamma, scheme, box, threads);
            }};
}

using Bulk = Dissipation<BulkPressure, NoConduction, BulkDetector>;
using Thermokinetic = Dissipation<SignalViscosity, Conduction<SignalSpeed>>;
using Switched = Scaled<SignalViscosity, ViscosityAlpha>;
using Reconstructed = Dissipation<ReconstructedViscosity, Conduction<ContactSpeed>, FlowSlopes>;

/// Each line: what it is called, and what it is made of.
const std::vector<Entry>& entries() {
    static const std::vector<Entry> all{
        entry<CubicSpline>("none", "no viscosity", 1.2, Dissipation<NoViscosity>{}),
        entry<CubicSpline>("von-neumann", "von Neumann–Richtmyer", 1.2, Bulk{}),
        entry<CubicSpline>("bulk", "bulk viscosity", 1.2, Bulk{{}, {}, {.a = 0, .b = 1}}),
        entry<CubicSpline>("monaghan-gingold", "Monaghan–Gingold 1983", 1.2,
                           Dissipation<AlphaBeta>{{.beta = 0}}),
        entry<CubicSpline>("alpha-beta", "α = 1, β = 2", 1.2, Dissipation<AlphaBeta>{}),
        entry<CubicSpline>("signal", "signal velocity", 1.2, Dissipation<SignalViscosity>{}),
        entry<CubicSpline>("thermokinetic", "thermokinetic", 1.2, Thermokinetic{}),
        entry<CubicSpline>("morris-monaghan", "Morris–Monaghan", 1.2,
                           Dissipation<Switched, NoConduction, MorrisMonaghan>{}),
        entry<CubicSpline>("price", "Price", 1.2, Dissipation<Switched, Conduction<OwnSpeed>, PriceSwitch>{}),
        entry<QuadraticSpline>("narrow", "signal velocity, narrow kernel", 1.0,
                               Dissipation<SignalViscosity>{{.K = 0.85}}),
        entry<QuadraticSpline>("reconstructed", "reconstructed", 1.0, Reconstructed{}),
    };
    return all;
}

/// The viscosity of 1983 with the kernels that it was tried with.
const std::vector<Entry>& with_other_kernels() {
    static const std::vector<Entry> all{
        entry<Gaussian>("mg-gaussian", "Gaussian", 1.0, Dissipation<AlphaBeta>{{.beta = 0}}),
        entry<SuperGaussian>("mg-super-gaussian", "super-Gaussian", 1.35,
                             Dissipation<AlphaBeta>{{.beta = 0}}),
    };
    return all;
}

std::vector<Method> methods_of(const std::vector<Entry>& entries) {
    std::vector<Method> list;
    for (const Entry& entry : entries) list.push_back(entry.method);
    return list;
}

}  // namespace

const std::vector<Method>& tube_methods() {
    static const std::vector<Method> methods = methods_of(entries());
    return methods;
}
const std::vector<Method>& kernel_methods() {
    static const std::vector<Method> methods = methods_of(with_other_kernels());
    return methods;
}

const Method& tube_method(const std::string& name) {
    for (const Method& method : tube_methods()) {
        if (method.name == name) return method;
    }
    throw std::invalid_argument{"no such method: " + name};
}

const Method& best_tube_method() {
    return tube_methods().back();
}

std::unique_ptr<Model<1>> make_model(const Method& method, std::size_t n, double gamma, const Box<1>& box,
                                     int threads) {
    for (const auto* list : {&entries(), &with_other_kernels()}) {
        for (const Entry& entry : *list) {
            if (entry.method.name == method.name) return entry.make(method.h_over_dx, n, gamma, box, threads);
        }
    }
    throw std::invalid_argument{"no such method: " + method.name};
}

}  // namespace sph
