#include "chapters/02_consistency/scenes/measured.hpp"

#include <algorithm>

#include "chapters/01_kernel_interpolation/scenes/integral.hpp"

namespace sph {
namespace {

/// The kernels of this chapter: each costs seconds of compiling.
template <int d, class Use>
void with_known_kernel(const std::string& name, Use&& use) {
    if (name == CubicSpline<d>::name) return use(CubicSpline<d>{});
    if (name == QuinticSpline<d>::name) return use(QuinticSpline<d>{});
    if (name == WendlandC4<d>::name) return use(WendlandC4<d>{});
    throw std::invalid_argument{"unknown kernel " + name};
}

template <class K, class... Estimates>
using Cloud = InterpolationWithin<K, Free, Estimates...>;

/// Calls use(cloud, points) with the particles that `set` describes and the listed estimates.
template <int d, class... Listed, class Use>
void with_cloud(const ParticleSet& set, const Function<d>& function, Use&& use) {
    with_known_kernel<d>(set.kernel, [&](auto kernel) {
        const auto points = make_points<d>(set.arrangement, set.per_side, set.jitter, set.seed);
        const double h = set.h_over_dx / static_cast<double>(set.per_side);
        use(Cloud<decltype(kernel), Listed...>{Free{}, points, h, function.value,
                                               set.volumes == Volumes::summed, set.threads});
    });
}

/// Whether neither the particle's kernel nor those of its neighbours, on which their volumes depend, reach an
/// end.
template <int d>
bool is_inside(const Vector<d>& x, double support) {
    return std::all_of(x.begin(), x.end(), [&](double c) { return c > 2 * support && c < 1 - 2 * support; });
}

}  // namespace

template <int d>
Estimated<d> estimate(const ParticleSet& set, const Function<d>& function) {
    Estimated<d> e;
    with_cloud<d, Value, PlainGradient, DifferenceGradient, Shepard, AxisGradient, MatrixGradient<>,
               LinearGradient<>, LinearFit<>, Extent>(set, function, [&](auto cloud) {
        using K = typename decltype(cloud)::Kernel;
        auto p = cloud.estimate();
        e.repairs = repair<K>(p, Free{}, cloud.smoothing().h, [](double larger) {
            return Effects{Shepard{},
                           AxisGradient{},
                           MatrixGradient<>{},
                           LinearGradient<>{.h = larger},
                           LinearFit<>{.h = larger},
                           Extent{.h = larger}};
        });
        e.x = p.x;
        e.exact = p.A;
        e.sph = p.value;
        e.plain = p.plain;
        e.difference = p.gradient;
        e.shepard = p.shepard;
        e.axis = p.axis;
        e.matrix = p.matrix;
        e.linear = p.linear;
        e.fit = p.fit[0];
        for (std::size_t a = 0; a < d; ++a) e.slope[a] = p.fit[a + 1];
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Vector<d> x = cloud.position(i), slope = function.gradient(x);
            e.inside.push_back(is_inside<d>(x, cloud.smoothing().reach()));
            for (std::size_t a = 0; a < d; ++a) e.exact_slope[a].push_back(slope[a]);
        }
    });
    return e;
}
template Estimated<1> estimate<1>(const ParticleSet&, const Function<1>&);
template Estimated<2> estimate<2>(const ParticleSet&, const Function<2>&);

Curvature cspm_curvature(const ParticleSet& set, const Function<1>& function) {
    Curvature result;
    with_cloud<1, CspmCurvature>(set, function, [&](auto cloud) {
        const auto& p = cloud.estimate();
        result = {p.x[0], p.curvature};
    });
    return result;
}

template <int d>
std::vector<Scheme<d>> schemes() {
    using E = Estimated<d>;
    std::vector<Scheme<d>> all{{"sph", "SPH", "2.8", "2.11", &E::sph, &E::plain},
                               {"differences", "differences", "", "2.14", nullptr, &E::difference}};
    if (d > 1) all.push_back({"by-axes", "CSPM by axes", "", "94 by axes", nullptr, &E::axis});
    all.push_back({"cspm", "CSPM", "92", "94", &E::shepard, &E::matrix});
    all.push_back({"linear", "linearly exact", "", "least squares", nullptr, &E::linear});
    all.push_back({"fit", "fitted line", "90 to first order", "90 to first order", &E::fit, &E::slope});
    return all;
}
template std::vector<Scheme<1>> schemes<1>();
template std::vector<Scheme<2>> schemes<2>();

namespace {

class SquaredError {
  public:
    void add(double estimate, double exact) {
        error_ += square(estimate - exact);
        size_ += square(exact);
    }
    double relative() const { return std::sqrt(error_ / size_); }

  private:
    double error_ = 0, size_ = 0;
};

}  // namespace

template <int d>
double value_error(const Estimated<d>& e, const Scheme<d>& scheme, Where where) {
    SquaredError error;
    for (std::size_t i = 0; i < e.exact.size(); ++i) {
        if (where == Where::everywhere || e.inside[i]) error.add((e.*scheme.value)[i], e.exact[i]);
    }
    return error.relative();
}
template double value_error<1>(const Estimated<1>&, const Scheme<1>&, Where);
template double value_error<2>(const Estimated<2>&, const Scheme<2>&, Where);

template <int d>
double slope_error(const Estimated<d>& e, const Scheme<d>& scheme, Where where) {
    SquaredError error;
    for (std::size_t a = 0; a < d; ++a) {
        for (std::size_t i = 0; i < e.exact.size(); ++i) {
            if (where == Where::everywhere || e.inside[i])
                error.add((e.*scheme.slope)[a][i], e.exact_slope[a][i]);
        }
    }
    return error.relative();
}
template double slope_error<1>(const Estimated<1>&, const Scheme<1>&, Where);
template double slope_error<2>(const Estimated<2>&, const Scheme<2>&, Where);

template <int d>
MomentDefects moment_defects(const ParticleSet& set) {
    MomentDefects defects;
    with_cloud<d, ZerothMoment, FirstMoment, SecondMoment>(set, polynomial<d>(0, 0, 0), [&](auto cloud) {
        const auto& p = cloud.estimate();
        using K = typename decltype(cloud)::Kernel;
        const double h = cloud.smoothing().h;
        double count = 0, extent = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Vector<d> x = cloud.position(i);
            if (!is_inside<d>(x, cloud.smoothing().reach())) continue;
            ++count;
            defects.m0 += square(p.m0[i] - 1);
            for (std::size_t a = 0; a < d; ++a) {
                defects.m1 += square(p.m1[a][i] / h);
                extent += p.m2[a][a][i] / (h * h * d);
            }
        }
        defects.m0 = std::sqrt(defects.m0 / count);
        defects.m1 = std::sqrt(defects.m1 / count);
        defects.m2 = extent / count / second_moment(K{}) - 1;
    });
    return defects;
}
template MomentDefects moment_defects<1>(const ParticleSet&);
template MomentDefects moment_defects<2>(const ParticleSet&);

template <int d>
AtTheEnd moments_at_the_end(const ParticleSet& set) {
    AtTheEnd end;
    with_cloud<d, ZerothMoment, FirstMoment>(set, polynomial<d>(0, 0, 0), [&](auto cloud) {
        const auto& p = cloud.estimate();
        const double h = cloud.smoothing().h, reach = cloud.smoothing().reach();
        const double dx = 1.0 / static_cast<double>(set.per_side);
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Vector<d> x = cloud.position(i);
            if (x[0] > 1.1 * reach || (d > 1 && std::abs(x[d - 1] - 0.5) > 0.51 * dx)) continue;
            if (d > 1 && x[d - 1] > 0.5) continue;
            end.distance_over_h.push_back(x[0] / h);
            end.m0.push_back(p.m0[i]);
            end.m1.push_back(p.m1[0][i] / h);
        }
    });
    return end;
}
template AtTheEnd moments_at_the_end<1>(const ParticleSet&);
template AtTheEnd moments_at_the_end<2>(const ParticleSet&);

namespace {

/// The kernel's integral over a line (d = 1: a point; d = 2: across) at distance t h from its centre, times
/// h.
template <class K>
double across(K kernel, double t) {
    if constexpr (K::dimension == 1) {
        return K::sigma * kernel.w(t);
    } else {
        if (t >= K::support) return 0;
        const Quadrature nodes = quadrature_over(std::sqrt(square(K::support) - t * t), {}, 16);
        double sum = 0;
        for (std::size_t n = 0; n < nodes.q.size(); ++n)
            sum += 2 * nodes.weight[n] * kernel.w(std::sqrt(t * t + square(nodes.q[n])));
        return K::sigma * sum;
    }
}

}  // namespace

template <int d>
KernelAtTheEnd integrals_at_the_end(const std::string& kernel_name, double s) {
    KernelAtTheEnd end;
    with_known_kernel<d>(kernel_name, [&](auto kernel) {
        using K = decltype(kernel);
        // Over t = (x_i - x)/h from -support to s: the half beyond the particle is whole, m0 = 1/2 + integral
        // to s.
        const Quadrature near = quadrature_over(std::min(s, K::support), {}, 16);
        const Quadrature far = quadrature_over(K::support, {}, 16);
        end.m0 = 0.5;
        for (std::size_t n = 0; n < near.q.size(); ++n) {
            const double weight = near.weight[n] * across(kernel, near.q[n]);
            end.m0 += weight;
            end.m1 += weight * near.q[n];
        }
        for (std::size_t n = 0; n < far.q.size(); ++n)
            end.m1 -= far.weight[n] * across(kernel, far.q[n]) * far.q[n];
    });
    return end;
}
template KernelAtTheEnd integrals_at_the_end<1>(const std::string&, double);
template KernelAtTheEnd integrals_at_the_end<2>(const std::string&, double);

}  // namespace sph
