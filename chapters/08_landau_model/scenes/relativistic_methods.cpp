#include <stdexcept>

#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "chapters/08_landau_model/relativistic_gas.hpp"
#include "chapters/08_landau_model/scenes/relativistic_tube.hpp"
#include "common/plot/method_looks.hpp"

namespace sph::landau {
namespace {

template <class Scheme>
TubeMethod relativistic(const char* name, const char* label, const char* kernel, double h_over_dx) {
    static constexpr double close = 1e-4;  // conservation does not hang on h: see chapter 4
    using Resolution = ConsistentH<AnyKernel<1>, OfBaryons>;
    const auto build = [](const TubeMethod& method,
                          const shocks::Setup<1>& setup) -> std::unique_ptr<Simulation<1>> {
        const IdealGas* state = setup.state.as<IdealGas>();
        if (!state) throw std::invalid_argument{"the relativistic gas must be an ideal one"};
        return std::make_unique<RelativisticGas<Resolution, Scheme, Box<1>>>(
            setup.n, Resolution{HRule{method.h_over_dx}, close, AnyKernel<1>{method.kernel}}, *state,
            with_parameters(Scheme{}, method.parameters), setup.box, setup.courant, setup.threads);
    };
    return {name, label, plot::look_of(name), kernel, h_over_dx, parameters_of(Scheme{}), build};
}

}  // namespace

const shocks::Methods<1>& relativistic_methods() {
    static const shocks::Methods<1> methods{
        "reconstructed",
        {relativistic<NoExchange>("none", "no dissipation", "cubic", 1.2),
         relativistic<ChowMonaghanExchange>("chow-monaghan", "Chow–Monaghan", "cubic", 1.2),
         relativistic<ReconstructedScheme>("reconstructed", "reconstructed", "quadratic", 1.0)}};
    return methods;
}

}  // namespace sph::landau
