#include "chapters/04_artificial_viscosity/scenes/plane_methods.hpp"

#include <stdexcept>

#include "chapters/01_kernel_interpolation/splines.hpp"
#include "chapters/01_kernel_interpolation/wendland.hpp"
#include "chapters/04_artificial_viscosity/scenes/model_of.hpp"
#include "chapters/04_artificial_viscosity/physical_viscosity.hpp"
#include "chapters/04_artificial_viscosity/reconstruction.hpp"

namespace sph {
namespace {

struct Entry {
    Method method;
    bool real = false;  ///< a viscosity of the fluid, with the parameter nu
    std::function<std::unique_ptr<Model<2>>(double h_over_dx, std::size_t, double, const Box<2>&, int,
                                            double nu)>
        make;
};

/// scheme_of(nu) is the method's dissipation.
template <template <int> class Kernel, class SchemeOf>
Entry entry(const char* name, const char* label, double h_over_dx, bool real, SchemeOf scheme_of) {
    using Scheme = decltype(scheme_of(0.0));
    return {{name, label, std::string{Kernel<2>::name}, h_over_dx},
            real,
            [scheme_of](double h, std::size_t n, double gamma, const Box<2>& box, int threads, double nu) {
                return std::make_unique<ModelOf<Kernel<2>, Scheme>>(n, h, gamma, scheme_of(nu), box, threads);
            }};
}
template <template <int> class Kernel, class Scheme>
Entry artificial(const char* name, const char* label, double h_over_dx, Scheme scheme) {
    return entry<Kernel>(name, label, h_over_dx, false, [scheme](double) { return scheme; });
}

using Sheared = Scaled<SignalViscosity, ShearFactor>;
using Reconstructed = Dissipation<ReconstructedViscosity, Conduction<ContactSpeed>, FlowSlopes>;
using Pairwise = Dissipation<PairwiseViscosity>;
using Stress = Dissipation<StressViscosity, NoConduction, StressDetector>;

/// Why Wendland C4, and why h = 1.6 spacings: with the cubic spline and 1.2 spacings a lattice that is
/// sheared buckles, and takes from the shear, at first, what a viscosity of 0.05 c_s h would; in shocks both
/// are equally good. Real viscosities need 2.6: at 2 spacings the order of the particles resists vortices
/// by tens of per cent of what viscosity does. (Measured: README, "A shear layer" and "Real viscosity".)
constexpr double narrow = 1.6, wide = 2.6;
template <int d>
using K = WendlandC4<d>;

/// Each line: what it is called, and what it is made of.
const std::vector<Entry>& entries() {
    static const std::vector<Entry> all{
        artificial<CubicSpline>("none-cubic", "no viscosity, cubic spline", 1.2, Dissipation<NoViscosity>{}),
        artificial<CubicSpline>("signal-cubic", "signal velocity, cubic spline", 1.2,
                                Dissipation<SignalViscosity>{}),
        artificial<K>("none", "no viscosity", narrow, Dissipation<NoViscosity>{}),
        artificial<K>("alpha-beta", "α = 1, β = 2", narrow, Dissipation<AlphaBeta>{}),
        artificial<K>("signal", "signal velocity", narrow, Dissipation<SignalViscosity>{}),
        artificial<K>("balsara", "Balsara", narrow, Dissipation<Sheared, NoConduction, Balsara>{}),
        artificial<K>("colagrossi", "Colagrossi", narrow, Dissipation<Sheared, NoConduction, Colagrossi>{}),
        artificial<K>("reconstructed", "reconstructed", narrow, Reconstructed{}),
        entry<K>("pairwise", "pairwise (8.9)", wide, true, [](double nu) { return Pairwise{{.nu = nu}}; }),
        entry<K>("stress", "stress", wide, true,
                 [](double nu) {
                     return Stress{{nu}, {}, {nu}};
                 }),
    };
    return all;
}

std::vector<Method> methods(bool real) {
    std::vector<Method> list;
    for (const Entry& entry : entries()) {
        if (entry.real == real) list.push_back(entry.method);
    }
    return list;
}

const Entry& entry_of(const std::string& name) {
    for (const Entry& entry : entries()) {
        if (entry.method.name == name) return entry;
    }
    throw std::invalid_argument{"no such method in two dimensions: " + name};
}

}  // namespace

const std::vector<Method>& plane_methods() {
    static const std::vector<Method> list = methods(false);
    return list;
}

const std::vector<Method>& viscous_methods() {
    static const std::vector<Method> list = methods(true);
    return list;
}

const Method& plane_method(const std::string& name) {
    return entry_of(name).method;
}

std::unique_ptr<Model<2>> make_model(const Method& method, std::size_t n, double gamma, const Box<2>& box,
                                     int threads, double nu) {
    return entry_of(method.name).make(method.h_over_dx, n, gamma, box, threads, nu);
}

}  // namespace sph
