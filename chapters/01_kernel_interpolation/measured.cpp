#include "chapters/01_kernel_interpolation/measured.hpp"

#include "chapters/01_kernel_interpolation/interpolation.hpp"
#include "chapters/01_kernel_interpolation/test_function.hpp"
#include "common/app/parallel.hpp"

namespace sph {
namespace {

/// Calls use(interpolation) with the interpolation that `setting` describes.
template <int d, class Use>
void with_interpolation(const Setting& setting, Use&& use) {
    const bool known = with_kernel<d>(setting.kernel, [&](auto kernel) {
        const auto points =
            make_points<d>(setting.arrangement, setting.per_side, setting.jitter, setting.seed);
        const double h = setting.h_over_dx / static_cast<double>(setting.per_side);
        use(Interpolation<decltype(kernel)>{points, h, TestFunction<d>{}});
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
    with_interpolation<d>(setting, [&](const auto& A) {
        for (auto* scalars : {&e.value, &e.twice, &e.laplacian}) scalars->resize(A.size());
        for (auto* vectors : {&e.x, &e.plain, &e.gradient, &e.weighted}) vectors->resize(A.size());
        app::parallel_for(A.size(), setting.threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                app::check_interrupt();
                const auto [v, p, g, w, t, b] =
                    A.template at<Value, PlainGradient, DifferenceGradient, DensityGradient,
                                  TwiceDifferentiated, Brookshaw>(i);
                e.x[i] = A.position(i);
                e.value[i] = v[0];
                e.plain[i] = p;
                e.gradient[i] = g;
                e.weighted[i] = w;
                e.twice[i] = t[0];
                e.laplacian[i] = b[0];
            }
        });
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

Map interpolate_at(const Setting& setting, const std::vector<Vector<2>>& positions) {
    Map map;
    with_interpolation<2>(setting, [&](const auto& A) {
        for (const Vector<2>& x : positions)
            map.value.push_back(std::get<0>(A.template evaluate<Value>(x))[0]);
        for (std::size_t i = 0; i < A.size(); ++i) map.particles.push_back(A.position(i));
    });
    return map;
}

}  // namespace sph
