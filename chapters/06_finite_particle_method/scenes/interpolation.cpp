#include "chapters/06_finite_particle_method/scenes/interpolation.hpp"

#include <algorithm>
#include <cmath>

#include "chapters/06_finite_particle_method/scenes/estimators.hpp"

namespace sph::fpm {

template <int d>
template <class Counts>
double Interpolated<d>::error_of(int degree, Counts&& counts) const {
    double off = 0, size = 0;
    for (std::size_t k = 0; k < derivatives<d>; ++k) {
        if (Taylor<d, 2>::terms[k].degree != degree) continue;
        for (std::size_t i = 0; i < inside.size(); ++i) {
            if (!counts(i)) continue;
            off += square(estimated[k][i] - exact[k][i]), size += square(exact[k][i]);
        }
    }
    return std::sqrt(off / size);
}

template <int d>
double Interpolated<d>::error(int degree, consistency::Where where) const {
    return error_of(degree,
                    [&](std::size_t i) { return inside[i] || where == consistency::Where::everywhere; });
}

template <int d>
double Interpolated<d>::error_within(double margin) const {
    return error_of(1, [&](std::size_t i) {
        return std::all_of(x.begin(), x.end(),
                           [&](const Column& c) { return c[i] > margin && c[i] < 1 - margin; });
    });
}

template <int d>
Interpolated<d> interpolate(const ParticleSet& set, const Smooth<d>& function, const Choice& choice) {
    Interpolated<d> result;
    result.x = set.points<d>();
    const std::size_t n = result.x[0].size();
    const AnyKernel<d> kernel{set.kernel};
    Estimates<d> estimates{estimator<d>(choice.member, choice.order), kernel};
    const Column m(n, 1.0 / static_cast<double>(n)), h{set.h()};
    const Rows<d>& rows = estimates.at_particles(result.x, m, h);
    for (std::size_t i = 0; i < n; ++i) {
        Vector<d> x;
        for (std::size_t a = 0; a < d; ++a) x[a] = result.x[a][i];
        for (std::size_t k = 0; k < derivatives<d>; ++k) result.exact[k].push_back(function(x, k));
        const double margin = 2 * kernel.support * set.h();
        result.inside.push_back(
            std::all_of(x.begin(), x.end(), [&](double c) { return c > margin && c < 1 - margin; }));
    }
    for (std::size_t k = 0; k < derivatives<d>; ++k)
        rows.apply(k, result.exact[0], Parity::even, result.estimated[k]);
    if (d == 1 && !estimates.estimator().has_second())
        rows.apply(1, result.estimated[1], Parity::even, result.estimated[2]);
    result.enlarged = estimates.enlarged();
    result.condition = estimates.conditions();
    result.entries = rows.entries();
    return result;
}

template struct Interpolated<1>;
template struct Interpolated<2>;
template struct Interpolated<3>;
template Interpolated<1> interpolate<1>(const ParticleSet&, const Smooth<1>&, const Choice&);
template Interpolated<2> interpolate<2>(const ParticleSet&, const Smooth<2>&, const Choice&);
template Interpolated<3> interpolate<3>(const ParticleSet&, const Smooth<3>&, const Choice&);

ParticleSet thousand(Arrangement arrangement) {
    ParticleSet set;
    set.arrangement = arrangement, set.per_side = 1000;
    set.h_over_dx = 2, set.jitter = 0.3;
    return set;
}

Neighbourhoods random_neighbourhoods(std::size_t sets, std::size_t n, double h_over_dx, const Choice& choice,
                                     const std::string& kernel, unsigned long seed) {
    Neighbourhoods all;
    double off = 0, size = 0;
    for (std::size_t s = 0; s < sets; ++s) {
        ParticleSet set;
        set.kernel = kernel, set.arrangement = Arrangement::random, set.per_side = n;
        set.h_over_dx = h_over_dx, set.seed = seed + s;
        const auto one = interpolate<1>(set, plane_wave<1>, choice);
        all.count += n;
        all.enlarged.flagged += one.enlarged.flagged, all.enlarged.left += one.enlarged.left;
        all.enlarged.largest_factor = std::max(all.enlarged.largest_factor, one.enlarged.largest_factor);
        all.enlarged.worst_condition = std::max(all.enlarged.worst_condition, one.enlarged.worst_condition);
        for (std::size_t i = 0; i < n; ++i)
            off += square(one.estimated[1][i] - one.exact[1][i]), size += square(one.exact[1][i]);
    }
    all.slope_error = std::sqrt(off / size);
    return all;
}

}  // namespace sph::fpm
