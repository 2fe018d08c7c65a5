#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "chapters/08_landau_model/fluids.hpp"
#include "chapters/09_transverse_expansion/corrected_force.hpp"
#include "chapters/09_transverse_expansion/scenes/expansion.hpp"
#include "common/plot/method_looks.hpp"

namespace sph::transverse {
namespace {

using K = AnyKernel<2>;
using Of = OfCurvedEntropy;

// [fluid]
/// Steps grow by a tenth from a small first one, as chapter 8's, because the edge starts from rest; and none
/// is longer than a tenth of tau, in which the coordinates themselves change: unless the steps are careless.
template <class Resolution>
std::unique_ptr<Integrated<2>> plane_of(const PlaneSetup& setup, Resolution resolution) {
    constexpr double first_step = 0.05, growth = 1.1, share_of_tau = 0.1;
    using Fluid = CurvedFluid<Resolution, ConformalFluid, BoostInvariant>;
    auto fluid = std::make_unique<Fluid>(setup.n, std::move(resolution), ConformalFluid{setup.c2},
                                         BoostInvariant{}, Free{}, setup.threads);
    if (setup.order == Order::fourth) {
        fluid->template integrate_by<RungeKutta4>();
    } else {
        fluid->template integrate_by<RungeKutta2>();
    }
    fluid->limit_steps(
        [&plane = *fluid, courant = setup.courant, careful = setup.careful, longest = 0.0]() mutable {
            const double tau = plane.resolved_at();
            const double crossing = courant * plane.crossing_time(tau);
            if (!careful) return crossing;
            const double allowed = std::min(crossing, share_of_tau * tau);
            longest = longest > 0 ? std::min(growth * longest, allowed) : first_step * allowed;
            return longest;
        });
    return fluid;
}
// [end]

using Build = std::function<std::unique_ptr<Integrated<2>>(const report::Method<Integrated<2>, PlaneSetup>&,
                                                           const PlaneSetup&)>;
const Build fixed = [](const auto& method, const PlaneSetup& setup) {
    const double spacing = setup.radius * std::sqrt(pi / static_cast<double>(setup.n));
    return plane_of(setup, FixedH<K, Of>{method.h_over_dx * spacing, K{method.kernel}});
};
constexpr double close = 1e-4;  // what is left is its square; neither entropy nor momentum hangs on h
const Build with_omega = [](const auto& method, const PlaneSetup& setup) {
    return plane_of(setup, ConsistentH<K, Of>{HRule{method.h_over_dx}, close, K{method.kernel}});
};
const Build own = [](const auto& method, const PlaneSetup& setup) {
    return plane_of(setup, WithoutOmega<K, Of>{HRule{method.h_over_dx}, close, K{method.kernel}});
};
const Build corrected = [](const auto& method, const PlaneSetup& setup) {
    return plane_of(setup, CorrectedH<K>{HRule{method.h_over_dx}, close, K{method.kernel}});
};

PlaneMethod method(const char* name, const char* label, const char* look, const Build& build, Places places,
                   bool solved) {
    return {{name, label, plot::look_of(look), "wendland-c4", 1.8, {}, build}, places, solved};
}

}  // namespace

const report::Methods<PlaneMethod>& plane_methods() {
    using enum Places;
    // [methods]
    static const report::Methods<PlaneMethod> methods{
        "spiral-graded",
        {method("fixed-h", "fixed $h$, hexagonal", "fixed-h", fixed, hexagonal, false),
         method("hexagonal", "hexagonal", "variable", own, hexagonal, false),
         method("rings", "rings", "rings", own, rings, false),
         method("relaxed", "relaxed", "relaxed", own, relaxed, false),
         method("spiral", "spiral", "spiral", own, spiral, false),
         method("spiral-solved", "spiral, solved", "spiral-solved", own, spiral, true),
         method("spiral-graded", "spiral, solved, graded", "spiral-graded", own, graded, true),
         method("grad-h", "graded, with grad-h terms", "graded", with_omega, graded, true),
         method("corrected", "graded, corrected", "linear", corrected, graded, true)}};
    // [end]
    return methods;
}

}  // namespace sph::transverse
