#include "chapters/05_tensile_instability/scenes/cure_methods.hpp"

#include <utility>

#include "chapters/01_kernel_interpolation/kernels.hpp"
#include "chapters/05_tensile_instability/lattice.hpp"
#include "chapters/05_tensile_instability/scenes/cure_kinds.hpp"
#include "common/plot/method_looks.hpp"

namespace sph::tensile {
namespace {

template <class K>
using Summed = FixedH<K>;

template <template <class> class Resolution = Summed, class Cure>
std::unique_ptr<Integrated<2>> liquid(const CureSetup& setup, Cure cure, double background = 0) {
    const LatticeBox& box = setup.box;
    Liquid state = box.state();
    state.P += background;
    using One = CuredLiquid<Resolution<AnyKernel<2>>, Box<2>, Cure>;
    auto made = std::make_unique<One>(box.size(), Resolution<AnyKernel<2>>{box.resolution()}, state,
                                      setup.space(), box.threads, std::move(cure));
    place(box, *made);
    return made;
}

double tension(const CureSetup& setup) {
    return std::max(0.0, -setup.box.pressure);
}
/// W at the spacing of the lattice.
double W_spacing(const LatticeBox& box) {
    double W = 0;
    with_kernel<2>(box.kernel, [&](const auto& one) { W = one.W(1.0, box.h_over_dx); });
    return W;
}
/// - 1/2 sum_j x grad W on the lattice: 1 for a kernel that is wide.
double lattice_stress(const std::string& kernel, double h) {
    double sum = 0;
    with_kernel<2>(kernel, [&](const auto& one) {
        for (const auto& j : lattice_kernel<std::decay_t<decltype(one)>>(h).half)
            sum -= dot(j.x, j.gradient);  // and the one at -x
    });
    return sum;
}

GentleViscosity viscosity(const CureMethod& method, const CureSetup& setup) {
    return {method.parameters.value("alpha"), setup.box.h_over_dx};
}
template <class... Force>
PairCure<Force...> pairs(const CureMethod& method, const CureSetup& setup, Force... force) {
    return {viscosity(method, setup), Effects{std::move(force)...}};
}
std::shared_ptr<Around> around(const CureSetup& setup) {
    return std::make_shared<Around>(setup.space(), setup.box.threads);
}

using Built = std::unique_ptr<Integrated<2>>;
using PressureOnly = PressureForce<>;

Built none(const CureMethod&, const CureSetup& setup) {
    return liquid(setup, Uncured{});
}
Built damped(const CureMethod& method, const CureSetup& setup) {
    return liquid(setup, pairs(method, setup, PressureOnly{}));
}
Built background(const CureMethod& method, const CureSetup& setup) {
    return liquid(setup, pairs(method, setup, PressureOnly{}),
                  tension(setup) * method.parameters.value("background"));
}
ArtificialPressure artificial(const CureMethod& method, const CureSetup& setup) {
    return {method.parameters.value("epsilon"), W_spacing(setup.box)};
}
Built stress(const CureMethod& method, const CureSetup& setup) {
    return liquid(setup, pairs(method, setup, PressureOnly{}, artificial(method, setup)));
}
Built stress_xsph(const CureMethod& method, const CureSetup& setup) {
    return liquid(setup, XsphCure<PressureOnly, ArtificialPressure>{
                             pairs(method, setup, PressureOnly{}, artificial(method, setup)),
                             method.parameters.value("xsph")});
}
Built xsph(const CureMethod& method, const CureSetup& setup) {
    return liquid(
        setup, XsphCure<PressureOnly>{pairs(method, setup, PressureOnly{}), method.parameters.value("xsph")});
}
Shift shift(const CureMethod& method, const CureSetup& setup, double R, double slope) {
    return {method.parameters.value("shift"), R, W_spacing(setup.box), slope, setup.box.h_over_dx};
}
Built shifting(const CureMethod& method, const CureSetup& setup) {
    return liquid(
        setup, ShiftCure<PressureOnly>{pairs(method, setup, PressureOnly{}), shift(method, setup, 0.2, 0)});
}
Built transport(const CureMethod& method, const CureSetup& setup) {
    return liquid(setup,
                  ShiftCure<PressureOnly, TransportStress>{
                      pairs(method, setup, PressureOnly{}, TransportStress{}), shift(method, setup, 0, 0)});
}
Built limited(const CureMethod& method, const CureSetup& setup) {
    return liquid(setup, ShiftCure<PressureOnly, TransportStress>{
                             pairs(method, setup, PressureOnly{}, TransportStress{}),
                             shift(method, setup, 0, method.parameters.value("slope"))});
}
Built share(const CureMethod& method, const CureSetup& setup) {
    return liquid(setup,
                  pairs(method, setup, PressureOnly{}, ShareOfDifference{method.parameters.value("weight")}));
}
Built slope(const CureMethod& method, const CureSetup& setup) {
    return liquid(setup, SlopeCure<>{pairs(method, setup)});
}
Built slope_stress(const CureMethod& method, const CureSetup& setup) {
    return liquid(setup, SlopeCure<ArtificialPressure>{pairs(method, setup, artificial(method, setup))});
}
/// Its density begins with what the sum finds, so that disorder makes the same forces at first.
Built cspm(const CureMethod& method, const CureSetup& setup) {
    auto made = liquid<EvolvedDensity>(setup, CspmCure{{pairs(method, setup)}});
    const auto summed = none(method, setup);
    summed->start(0);
    summed->resolve(0);
    made->get<Density>() = summed->get<Density>();
    return made;
}
Built linear_exact(const CureMethod& method, const CureSetup& setup) {
    return liquid(setup, LinearExactCure{viscosity(method, setup)});
}
ReferenceCure on_first_places(const CureSetup& setup) {
    return {setup.box.resolution().smoothing(), setup.box.state(), around(setup)};
}
Built reference(const CureMethod&, const CureSetup& setup) {
    return liquid(setup, on_first_places(setup));
}
Built lagrangian_kernel(const CureMethod&, const CureSetup& setup) {
    ReferenceCure cure = on_first_places(setup);
    cure.corrected = false;
    return liquid(setup, std::move(cure));
}
Built hourglass(const CureMethod& method, const CureSetup& setup) {
    ReferenceCure cure = on_first_places(setup);
    cure.hourglass = method.parameters.value("hourglass");
    return liquid(setup, std::move(cure));
}
Built balanced(const CureMethod& method, const CureSetup& setup) {
    const LatticeBox& box = setup.box;
    const AnyKernel<2> narrow{box.kernel};
    const QuinticSpline<2> wide;
    const double wide_h = method.parameters.value("width") * narrow.support * box.h_over_dx / wide.support;
    BalancedCure cure{viscosity(method, setup),
                      {box.h_over_dx,
                       {narrow, wide, wide_h / box.h_over_dx, lattice_stress(box.kernel, box.h_over_dx),
                        lattice_stress("quintic", wide_h)}},
                      {tension(setup) * method.parameters.value("background"), 1.0},
                      around(setup)};
    return liquid(setup, std::move(cure));
}

CureMethod named(std::string name, std::string label, app::Parameters parameters,
                 std::function<Built(const CureMethod&, const CureSetup&)> build) {
    CureMethod method;
    method.name = std::move(name), method.label = std::move(label);
    method.kernel = "cubic", method.h_over_dx = 1.2;
    method.parameters = std::move(parameters), method.build = std::move(build);
    return method;
}
app::Parameter parameter(std::string name, double value, app::Range range, std::string meaning) {
    return {std::move(name), value, range, std::move(meaning)};
}
app::Parameters only(const app::Parameter& one) {
    app::Parameters all;
    all.add(one);
    return all;
}
/// A little viscosity, for all of them the same: it takes out the heat of disorder.
app::Parameters with_alpha(std::initializer_list<app::Parameter> more, double alpha = 0.1) {
    app::Parameters all;
    for (const app::Parameter& one : more) all.add(one);
    all.add(parameter("alpha", alpha, {0, 10}, "viscosity, nu = alpha c h/8"));
    return all;
}

std::vector<CureMethod> listed() {
    const auto epsilon = parameter("epsilon", 0.2, {0, 10}, "strength of the artificial stress");
    const auto xsph_share = parameter("xsph", 0.5, {0, 1}, "share of the neighbours' mean velocity");
    const auto by = [](double value) {
        return parameter("shift", value, {0, 10}, "velocity of the shift [c h |g|]");
    };
    const auto pressure = [](double value) {
        return parameter("background", value, {0, 100}, "background pressure over the tension");
    };
    CureMethod wendland = named("wendland", "Wendland kernel", with_alpha({}), damped);
    wendland.kernel = "wendland-c2", wendland.h_over_dx = 2;
    return {
        named("none", "none", {}, none),
        named("viscosity", "viscosity", with_alpha({}, 1), damped),
        wendland,
        named("stress", "artificial stress", with_alpha({epsilon}), stress),
        named("xsph", "XSPH", with_alpha({xsph_share}), xsph),
        named("stress-xsph", "artificial stress, XSPH", with_alpha({epsilon, xsph_share}), stress_xsph),
        named("shifting", "shifting", with_alpha({by(0.5)}), shifting),
        named("transport", "transport velocity", with_alpha({by(0.5)}), transport),
        named("limited", "limited transport",
              with_alpha({by(0.5), parameter("slope", 100, {0, 1e6}, "of the limiter, in (h |g|)^2")}),
              limited),
        named("difference", "share of $P$_{j} - $P$_{i}",
              with_alpha({parameter("weight", 0.9, {0, 1}, "share of the difference")}), share),
        named("corrected", "corrected slope", with_alpha({}, 0.5), slope),
        named("corrected-stress", "corrected slope, artificial stress", with_alpha({epsilon}, 0.5),
              slope_stress),
        named("cspm", "CSPM", with_alpha({}, 0.5), cspm),
        named("linear-exact", "linear-exact, antisymmetric", with_alpha({}), linear_exact),
        named("reference", "total Lagrangian", {}, reference),
        named("lagrangian-kernel", "Lagrangian kernel", {}, lagrangian_kernel),
        named("hourglass", "total Lagrangian, hourglass control",
              only(parameter("hourglass", 1, {0, 100}, "stiffness against hourglass modes [K]")), hourglass),
        named("background", "background pressure", with_alpha({pressure(1.25)}), background),
        named("balanced", "balanced background",
              with_alpha({pressure(1.5), parameter("width", 1.875, {1.1, 4}, "wide over narrow support")}),
              balanced),
    };
}

}  // namespace

Box<2> CureSetup::space() const {
    if (!drop) return box.box();
    return {{-1e3, -1e3}, {1e3, 1e3}, Face::free};
}

const CureMethods& cure_methods() {
    static const CureMethods methods{"balanced", listed()};
    return methods;
}

std::unique_ptr<Integrated<2>> cured(const CureMethod& method, CureSetup setup) {
    setup.box.kernel = method.kernel, setup.box.h_over_dx = method.h_over_dx;
    auto liquid = method.make(setup);
    liquid->integrate_by<RungeKutta4>();
    liquid->limit_steps([dt = setup.box.courant] { return dt; });
    liquid->start(0);
    return liquid;
}

const Columns<2>& motion_of(const Integrated<2>& liquid) {
    return liquid.has<TransportVelocity>() ? liquid.get<TransportVelocity>() : liquid.get<Velocity>();
}

}  // namespace sph::tensile
