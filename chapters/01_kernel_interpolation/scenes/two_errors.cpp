#include "chapters/01_kernel_interpolation/scenes/two_errors.hpp"

#include "chapters/01_kernel_interpolation/fourier.hpp"
#include "chapters/01_kernel_interpolation/interpolation.hpp"
#include "chapters/01_kernel_interpolation/scenes/test_function.hpp"
#include "common/report/norms.hpp"

namespace sph::interpolation {
namespace {

constexpr double k = 2 * pi;

/// Mean square of the relative error of A at the particles of one set.
template <class Function>
double squared_error(const Setting& setting, Function&& A) {
    Interpolation<AnyKernel<1>, Value> line{
        make_points<1>(setting.arrangement, setting.per_side, setting.jitter, setting.seed),
        setting.h(),
        A,
        false,
        setting.threads,
        AnyKernel<1>{setting.kernel}};
    report::SquaredError error;
    const auto& p = line.estimate();
    for (std::size_t i = 0; i < p.size(); ++i) error.add(p.value[i], A(line.position(i)));
    return error.relative() * error.relative();
}

/// What the lattice adds to a wave: all others that it cannot distinguish from it (Poisson's formula). The
/// terms fall like r^-4, so that 5000 of them leave 1e-13.
double aliases(double kh, double h_over_dx) {
    double sum = 0;
    for (int r = 1; r <= 5000; ++r) {
        const double apart = 2 * pi * r * h_over_dx;
        sum += transform(CubicSpline<1>{}, kh + apart) + transform(CubicSpline<1>{}, kh - apart);
    }
    return sum;
}

}  // namespace

double Bumps::of(std::size_t j, double place) const {
    const double r = std::abs(place - x[j] - std::round(place - x[j]));
    return V * A[j] * CubicSpline<1>::W(r, h);
}

double Bumps::sum(double place) const {
    double total = 0;
    for (std::size_t j = 0; j < x.size(); ++j) total += of(j, place);
    return total;
}

Bumps bumps(std::size_t n, double h_over_dx, double jitter, std::uint64_t seed) {
    const double dx = 1 / static_cast<double>(n);
    Bumps all;
    all.x = make_points<1>(Arrangement::jittered, n, jitter, seed)[0];
    all.h = h_over_dx * dx;
    all.V = dx;
    for (const double x : all.x) all.A.push_back(TestFunction<1>::value({x}));
    return all;
}

WaveErrors wave_errors(const Setting& setting) {
    const double kh = k * setting.h();
    WaveErrors errors{.smoothing = std::abs(transform(CubicSpline<1>{}, kh) - 1)};
    const bool even = setting.arrangement == Arrangement::even;
    const int sets = even ? 1 : 4;
    double constant = 0, wave = 0;
    Setting one = setting;
    for (int set = 0; set < sets; ++set, ++one.seed) {
        constant += squared_error(one, [](const Vector<1>&) { return 1.0; }) / sets;
        wave += squared_error(one, [](const Vector<1>& x) { return std::cos(k * x[0]); }) / sets;
    }
    errors.sampling = even ? std::abs(aliases(kh, setting.h_over_dx)) : std::sqrt(constant);
    errors.measured = std::sqrt(wave);
    return errors;
}

}  // namespace sph::interpolation
