#include "chapters/01_kernel_interpolation/scenes/measured.hpp"

#include "chapters/01_kernel_interpolation/interpolation.hpp"
#include "chapters/01_kernel_interpolation/scenes/test_function.hpp"

namespace sph {
namespace {

/// Calls use(interpolation) with the interpolation of the listed estimates that `setting` describes.
template <int d, class... Listed, class Use>
void with_interpolation(const Setting& setting, Use&& use) {
    const bool known = with_kernel<d>(setting.kernel, [&](auto kernel) {
        const auto points =
            make_points<d>(setting.arrangement, setting.per_side, setting.jitter, setting.seed);
        const double h = setting.h_over_dx / static_cast<double>(setting.per_side);
        use(Interpolation<decltype(kernel), Listed...>{points, h, TestFunction<d>{}, true, setting.threads});
    });
    if (!known) throw std::invalid_argument{"unknown kernel " + setting.kernel};
}

/// Relative L2 error, sqrt(sum (estimate - exact)^2 / sum exact^2).
class SquaredError {
  public:
    void add(double estimate, double exact) {
        error_ += square(estimate - exact);
        size_ += square(exact);
    }
    template <int d>
    void add(const Vector<d>& estimate, const Vector<d>& exact) {
        for (std::size_t a = 0; a < d; ++a) add(estimate[a], exact[a]);
    }
    double relative() const { return std::sqrt(error_ / size_); }

  private:
    double error_ = 0, size_ = 0;
};

}  // namespace

template <int d>
Estimates<d> estimates_at_particles(const Setting& setting) {
    Estimates<d> e;
    with_interpolation<d, Value, PlainGradient, DifferenceGradient, DensityGradient, TwiceDifferentiated,
                       Brookshaw>(setting, [&](auto A) {
        const auto& p = A.estimate();
        e.value = p.value;
        e.twice = p.twice;
        e.laplacian = p.laplacian;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto row =
                load<d>(p, i, List<Position, PlainGradient, DifferenceGradient, DensityGradient>{});
            e.x.push_back(row.x);
            e.plain.push_back(row.plain);
            e.gradient.push_back(row.gradient);
            e.weighted.push_back(row.weighted);
        }
    });
    return e;
}
template Estimates<1> estimates_at_particles<1>(const Setting&);
template Estimates<2> estimates_at_particles<2>(const Setting&);

template <int d>
Errors errors_of(const Estimates<d>& e) {
    using Exact = TestFunction<d>;
    SquaredError value, plain, gradient, weighted, twice, laplacian;
    for (std::size_t i = 0; i < e.x.size(); ++i) {
        const Vector<d> slope = Exact::gradient(e.x[i]);
        value.add(e.value[i], Exact::value(e.x[i]));
        plain.add<d>(e.plain[i], slope);
        gradient.add<d>(e.gradient[i], slope);
        weighted.add<d>(e.weighted[i], slope);
        twice.add(e.twice[i], Exact::laplacian(e.x[i]));
        laplacian.add(e.laplacian[i], Exact::laplacian(e.x[i]));
    }
    return {value.relative(),    plain.relative(), gradient.relative(),
            weighted.relative(), twice.relative(), laplacian.relative()};
}
template Errors errors_of<1>(const Estimates<1>&);
template Errors errors_of<2>(const Estimates<2>&);

Map interpolate_at(const Setting& setting, const Columns<2>& positions) {
    Map map;
    with_interpolation<2, Value>(setting, [&](auto A) {
        map.value = A.estimate_at(positions).value;
        map.particles = A.particles().x;
    });
    return map;
}

}  // namespace sph
