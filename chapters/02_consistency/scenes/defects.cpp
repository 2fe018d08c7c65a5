#include "chapters/02_consistency/scenes/defects.hpp"

#include "chapters/01_kernel_interpolation/scenes/integral.hpp"
#include "chapters/02_consistency/scenes/cloud.hpp"

namespace sph::consistency {
namespace {

using interpolation::Quadrature;
using interpolation::quadrature_over;

/// Calls use(kernel) with the kernel of that name.
template <int d, class Use>
void with_known_kernel(const std::string& name, Use&& use) {
    if (!with_kernel<d>(name, use)) throw std::invalid_argument{"unknown kernel " + name};
}

/// The particles and all of their moments.
template <int d>
auto moments_of(const ParticleSet& set) {
    return cloud_of<d, ZerothMoment, FirstMoment, SecondMoment>(set, polynomial<d>(0, 0, 0));
}

}  // namespace

template <int d>
MomentDefects moment_defects(const ParticleSet& set) {
    auto cloud = moments_of<d>(set);
    const auto& p = cloud.estimate();
    const double h = cloud.smoothing().h;
    MomentDefects defects;
    double count = 0, extent = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (!is_inside<d>(cloud.position(i), cloud.smoothing().reach())) continue;
        ++count;
        defects.m0 += square(p.m0[i] - 1);
        for (std::size_t a = 0; a < d; ++a) {
            defects.m1 += square(p.m1[a][i] / h);
            extent += p.m2[a][a][i] / (h * h * d);
        }
    }
    defects.m0 = std::sqrt(defects.m0 / count);
    defects.m1 = std::sqrt(defects.m1 / count);
    with_known_kernel<d>(set.kernel, [&](auto kernel) {
        defects.m2 = extent / count / interpolation::second_moment(kernel) - 1;
    });
    return defects;
}
template MomentDefects moment_defects<1>(const ParticleSet&);
template MomentDefects moment_defects<2>(const ParticleSet&);

template <int d>
AtTheEnd moments_at_the_end(const ParticleSet& set) {
    auto cloud = moments_of<d>(set);
    const auto& p = cloud.estimate();
    const double h = cloud.smoothing().h, reach = cloud.smoothing().reach();
    const double dx = 1.0 / static_cast<double>(set.per_side);
    AtTheEnd end;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vector<d> x = cloud.position(i);
        if (x[0] > 1.1 * reach || (d > 1 && std::abs(x[d - 1] - 0.5) > 0.51 * dx)) continue;
        if (d > 1 && x[d - 1] > 0.5) continue;
        end.distance_over_h.push_back(x[0] / h);
        end.m0.push_back(p.m0[i]);
        end.m1.push_back(p.m1[0][i] / h);
    }
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

}  // namespace sph::consistency
