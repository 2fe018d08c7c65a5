#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "chapters/08_landau_model/entropic_fluid.hpp"
#include "chapters/08_landau_model/fluids.hpp"
#include "chapters/08_landau_model/scenes/slab.hpp"
#include "common/plot/method_looks.hpp"

namespace sph::landau {
namespace {

using K = AnyKernel<1>;

/// Entropy at rest, in steps that grow by a tenth from a small first one: the particles at the edge start
/// from rest, and what RK4 misses of their start it misses for good.
template <class Resolution>
std::unique_ptr<Integrated<1>> slab_of(const SlabSetup& setup, Resolution resolution) {
    constexpr double first_step = 0.05, growth = 1.1;
    const std::size_t n = setup.cells.size() - 1;
    auto fluid = std::make_unique<EntropicFluid<Resolution, ConformalFluid>>(n, std::move(resolution),
                                                                             ConformalFluid{}, setup.threads);
    for (std::size_t i = 0; i < n; ++i) {
        fluid->particles.x[0][i] = 0.5 * (setup.cells[i] + setup.cells[i + 1]);
        fluid->particles.nu[i] = setup.cells[i + 1] - setup.cells[i];
        fluid->particles.s_star[i] = 1;
    }
    fluid->start(0);
    fluid->template integrate_by<RungeKutta4>();
    fluid->limit_steps([&slab = *fluid, courant = setup.courant, longest = 0.0]() mutable {
        const double allowed = courant * slab.crossing_time();
        longest = longest > 0 ? std::min(growth * longest, allowed) : first_step * allowed;
        return longest;
    });
    return fluid;
}

using Build = std::function<std::unique_ptr<Integrated<1>>(const report::Method<Integrated<1>, SlabSetup>&,
                                                           const SlabSetup&)>;
// [builds]
const Build fixed = [](const auto& method, const SlabSetup& setup) {
    const double spacing = 2 / static_cast<double>(setup.cells.size() - 1);
    return slab_of(setup, FixedH<K, OfEntropy>{method.h_over_dx * spacing, K{method.kernel}});
};
const Build variable = [](const auto& method, const SlabSetup& setup) {
    constexpr double close = 1e-7;  // leaves 1e-14: the energy hangs on h
    return slab_of(setup, ConsistentH<K, OfEntropy>{HRule{method.h_over_dx}, close, K{method.kernel}});
};
// [end]
const Build without_omega = [](const auto& method, const SlabSetup& setup) {
    return slab_of(setup, WithoutOmega<K, OfEntropy>{HRule{method.h_over_dx}, 1e-12, K{method.kernel}});
};

}  // namespace

const report::Methods<SlabMethod>& slab_methods() {
    static const report::Methods<SlabMethod> methods{
        "narrow-graded",
        {{{"fixed-4", "fixed $h$ = 4 d$x$", plot::look_of("fixed-4"), "cubic", 4, {}, fixed}},
         {{"fixed-10", "fixed $h$ = 10 d$x$", plot::look_of("fixed-10"), "cubic", 10, {}, fixed}},
         {{"fixed-20", "fixed $h$ = 20 d$x$", plot::look_of("fixed-20"), "cubic", 20, {}, fixed}},
         {{"variable", "$h$ = 2 ν/$s$*", plot::look_of("variable"), "cubic", 2, {}, variable}},
         {{"without-omega",
           "$h$ = 2 ν/$s$*, no grad-h terms",
           plot::look_of("without-omega"),
           "cubic",
           2,
           {},
           without_omega}},
         {{"graded", "$h$ = 2 ν/$s$*, graded", plot::look_of("graded"), "cubic", 2, {}, variable}, true},
         {{"narrow", "quadratic, $h$ = ν/$s$*", plot::look_of("quadratic-h"), "quadratic", 1, {}, variable}},
         {{"narrow-graded",
           "quadratic, $h$ = ν/$s$*, graded",
           plot::look_of("narrow-graded"),
           "quadratic",
           1,
           {},
           variable},
          true}}};
    return methods;
}

}  // namespace sph::landau
