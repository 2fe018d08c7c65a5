#include "chapters/01_kernel_interpolation/scenes/measured.hpp"

#include "chapters/01_kernel_interpolation/interpolation.hpp"
#include "chapters/01_kernel_interpolation/scenes/test_function.hpp"
#include "common/report/norms.hpp"

namespace sph::interpolation {
namespace {

/// The interpolation of the listed estimates that `setting` describes.
template <int d, class... Listed>
auto interpolation_of(const Setting& setting) {
    return Interpolation<AnyKernel<d>, Listed...>{
        make_points<d>(setting.arrangement, setting.per_side, setting.jitter, setting.seed),
        setting.h(),
        TestFunction<d>{},
        true,
        setting.threads,
        AnyKernel<d>{setting.kernel}};
}

template <int d>
void add(report::SquaredError& error, const Vector<d>& estimate, const Vector<d>& exact) {
    for (std::size_t a = 0; a < d; ++a) error.add(estimate[a], exact[a]);
}

}  // namespace

template <int d>
Estimates<d> estimates_at_particles(const Setting& setting) {
    // [listed]
    auto A = interpolation_of<d, Value, PlainGradient, DifferenceGradient, DensityGradient,
                              TwiceDifferentiated, Brookshaw>(setting);
    const auto& p = A.estimate();
    // [end]
    Estimates<d> e;
    e.value = p.value;
    e.twice = p.twice;
    e.laplacian = p.laplacian;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto row = load<d>(p, i, List<Position, PlainGradient, DifferenceGradient, DensityGradient>{});
        e.x.push_back(row.x);
        e.plain.push_back(row.plain);
        e.gradient.push_back(row.gradient);
        e.weighted.push_back(row.weighted);
    }
    return e;
}
template Estimates<1> estimates_at_particles<1>(const Setting&);
template Estimates<2> estimates_at_particles<2>(const Setting&);
template Estimates<3> estimates_at_particles<3>(const Setting&);

template <int d>
Errors errors_of(const Estimates<d>& e) {
    using Exact = TestFunction<d>;
    report::SquaredError value, plain, gradient, weighted, twice, laplacian;
    for (std::size_t i = 0; i < e.x.size(); ++i) {
        const Vector<d> slope = Exact::gradient(e.x[i]);
        value.add(e.value[i], Exact::value(e.x[i]));
        add<d>(plain, e.plain[i], slope);
        add<d>(gradient, e.gradient[i], slope);
        add<d>(weighted, e.weighted[i], slope);
        twice.add(e.twice[i], Exact::laplacian(e.x[i]));
        laplacian.add(e.laplacian[i], Exact::laplacian(e.x[i]));
    }
    return {value.relative(),    plain.relative(), gradient.relative(),
            weighted.relative(), twice.relative(), laplacian.relative()};
}
template Errors errors_of<1>(const Estimates<1>&);
template Errors errors_of<2>(const Estimates<2>&);
template Errors errors_of<3>(const Estimates<3>&);

Map interpolate_at(const Setting& setting, const Columns<2>& positions) {
    auto A = interpolation_of<2, Value>(setting);
    return {A.estimate_at(positions).value, A.particles().x};
}

}  // namespace sph::interpolation
