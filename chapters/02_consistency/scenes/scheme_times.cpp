#include "chapters/02_consistency/scenes/scheme_times.hpp"

#include "chapters/01_kernel_interpolation/scenes/cost_measures.hpp"
#include "chapters/01_kernel_interpolation/scenes/test_function.hpp"

namespace sph::consistency {
namespace {

template <int d, class... Listed>
double time_of(report::Run& run, const ParticleSet& set) {
    InterpolationWithin<QuinticSpline<d>, Free, Listed...> cloud{Free{}, set.points<d>(), set.h(),
                                                                 interpolation::TestFunction<d>{}};
    return interpolation::ns_per_point(run, cloud);
}

}  // namespace

template <int d>
double slope_ns_per_point(report::Run& run, const std::string& scheme, const ParticleSet& set) {
    if (scheme == "differences") return time_of<d, DifferenceGradient>(run, set);
    if (scheme == "cspm") return time_of<d, MatrixGradient<>>(run, set);
    if (scheme == "linear") return time_of<d, LinearGradient<>>(run, set);
    if (scheme == "fit") return time_of<d, LinearFit<>>(run, set);
    throw std::invalid_argument{"no such scheme: " + scheme};
}
template double slope_ns_per_point<1>(report::Run&, const std::string&, const ParticleSet&);
template double slope_ns_per_point<2>(report::Run&, const std::string&, const ParticleSet&);

const std::vector<ListedSchemes>& listed_schemes() {
    static const std::vector<ListedSchemes> all{
        {"value", time_of<2, Value>},
        {"CSPM value (2.3)", time_of<2, Shepard>},
        {"slope (1.12)", time_of<2, DifferenceGradient>},
        {"CSPM slope (2.4)", time_of<2, MatrixGradient<>>},
        {"linearly exact slope", time_of<2, LinearGradient<>>},
        {"fitted line: value and slope", time_of<2, LinearFit<>>},
        {"CSPM value and slope", time_of<2, Shepard, MatrixGradient<>>}};
    return all;
}

}  // namespace sph::consistency
