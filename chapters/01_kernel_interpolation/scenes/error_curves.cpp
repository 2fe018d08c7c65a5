#include "chapters/01_kernel_interpolation/scenes/error_curves.hpp"

#include <cmath>

namespace sph::interpolation {
namespace {

/// Particles along a side, from the fewest on.
std::vector<std::size_t> resolutions(bool quick, int dimension) {
    if (dimension == 1)
        return quick ? std::vector<std::size_t>{32, 64, 128, 256, 512}
                     : std::vector<std::size_t>{32, 64, 128, 256, 512, 1024, 2048, 4096};
    if (dimension == 3)
        return quick ? std::vector<std::size_t>{8, 12, 16} : std::vector<std::size_t>{8, 12, 16, 24, 32};
    return quick ? std::vector<std::size_t>{16, 24, 32, 48, 64}
                 : std::vector<std::size_t>{16, 24, 32, 48, 64, 96, 128, 192, 256};
}

/// Root mean square of the errors over a few sets of particles.
template <int d>
Errors mean_errors(Setting setting) {
    const int sets = setting.arrangement == Arrangement::even ? 1 : 4;
    Errors mean;
    for (int set = 0; set < sets; ++set) {
        const Errors e = errors_of<d>(setting);
        ++setting.seed;
        for (const auto error : {&Errors::value, &Errors::gradient, &Errors::laplacian, &Errors::twice})
            mean.*error += e.*error * (e.*error) / sets;
    }
    for (const auto error : {&Errors::value, &Errors::gradient, &Errors::laplacian, &Errors::twice})
        mean.*error = std::sqrt(mean.*error);
    return mean;
}

}  // namespace

const std::vector<ParticleSeries>& particle_series() {
    static const std::vector<ParticleSeries> series{
        {"even", "even", "even", Arrangement::even, false, plot::Marker::circle},
        {"jittered", "jittered", "jittered", Arrangement::jittered, false, plot::Marker::square},
        {"random", "random", "random", Arrangement::random, false, plot::Marker::triangle_up},
        {"jittered-growing", "jittered, $h$ ∝ d$x$^{1/2}", "jittered, h ∝ √dx", Arrangement::jittered, true,
         plot::Marker::diamond}};
    return series;
}

template <int d>
ErrorCurves error_curves(const ParticleSeries& series, const SmoothingOptions& options,
                         const report::Run& run) {
    ErrorCurves curves;
    const std::vector<std::size_t> sides = resolutions(run.quick(), d);
    for (const std::size_t n : sides) {
        Setting setting = options.setting(series.arrangement, n, run);
        if (series.growing_h)
            setting.h_over_dx *= std::sqrt(static_cast<double>(n) / static_cast<double>(sides.front()));
        const Errors errors = mean_errors<d>(setting);
        curves.n.push_back(static_cast<double>(n));
        curves.value.push_back(errors.value);
        curves.gradient.push_back(errors.gradient);
        curves.laplacian.push_back(errors.laplacian);
        curves.twice.push_back(errors.twice);
    }
    return curves;
}
template ErrorCurves error_curves<1>(const ParticleSeries&, const SmoothingOptions&, const report::Run&);
template ErrorCurves error_curves<2>(const ParticleSeries&, const SmoothingOptions&, const report::Run&);
template ErrorCurves error_curves<3>(const ParticleSeries&, const SmoothingOptions&, const report::Run&);

}  // namespace sph::interpolation
