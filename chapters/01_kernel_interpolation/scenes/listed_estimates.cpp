#include "chapters/01_kernel_interpolation/scenes/listed_estimates.hpp"

#include "chapters/01_kernel_interpolation/interpolation.hpp"
#include "chapters/01_kernel_interpolation/scenes/cost_measures.hpp"
#include "chapters/01_kernel_interpolation/scenes/test_function.hpp"

namespace sph::interpolation {
namespace {

template <class... Listed>
double time_of(report::Run& run, double h_over_dx) {
    constexpr std::size_t n = ListedEstimates::per_side;
    Interpolation<CubicSpline<2>, Listed...> A{make_points<2>(Arrangement::jittered, n, 0.2, run.seed()),
                                               h_over_dx / static_cast<double>(n), TestFunction<2>{}};
    return ns_per_point(run, A);
}

}  // namespace

const std::vector<ListedEstimates>& listed_estimates() {
    static const std::vector<ListedEstimates> all{
        {"value", time_of<Value>},
        {"gradient", time_of<DifferenceGradient>},
        {"value + gradient", time_of<Value, DifferenceGradient>},
        {"value + gradient + Laplacian", time_of<Value, DifferenceGradient, Brookshaw>},
        {"all and the tensor (1.17)", time_of<Value, DifferenceGradient, Brookshaw, TensorHessian>}};
    return all;
}

}  // namespace sph::interpolation
