#include "chapters/02_consistency/scenes/measured.hpp"

#include "chapters/02_consistency/scenes/cloud.hpp"
#include "common/report/norms.hpp"

namespace sph::consistency {

template <int d>
Estimated<d> estimate(const ParticleSet& set, const Function<d>& function) {
    auto cloud = cloud_of<d, Value, PlainGradient, DifferenceGradient, Shepard, AxisGradient,
                          MatrixGradient<>, LinearGradient<>, LinearFit<>, Extent>(set, function);
    auto p = cloud.estimate();
    Estimated<d> e;
    e.repairs = repair(p, Free{}, cloud.smoothing(), [](double h) {
        return Effects{Shepard{},           AxisGradient{}, MatrixGradient<>{}, LinearGradient<>{.h = h},
                       LinearFit<>{.h = h}, Extent{.h = h}};
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
    return e;
}
template Estimated<1> estimate<1>(const ParticleSet&, const Function<1>&);
template Estimated<2> estimate<2>(const ParticleSet&, const Function<2>&);

Curvature cspm_curvature(const ParticleSet& set, const Function<1>& function) {
    auto cloud = cloud_of<1, CspmCurvature>(set, function);
    const auto& p = cloud.estimate();
    return {p.x[0], p.curvature};
}

template <int d>
std::vector<Scheme<d>> schemes() {
    using E = Estimated<d>;
    std::vector<Scheme<d>> all{{"sph", "SPH", "1.3", "1.11", &E::sph, &E::plain},
                               {"differences", "differences", "", "1.12", nullptr, &E::difference}};
    if (d > 1) all.push_back({"by-axes", "CSPM by axes", "", "2.4 by axes", nullptr, &E::axis});
    all.push_back({"cspm", "CSPM", "2.3", "2.4", &E::shepard, &E::matrix});
    all.push_back({"linear", "linearly exact", "", "2.5", nullptr, &E::linear});
    all.push_back({"fit", "fitted line", "2.6", "2.6", &E::fit, &E::slope});
    return all;
}
template std::vector<Scheme<1>> schemes<1>();
template std::vector<Scheme<2>> schemes<2>();

template <int d>
double value_error(const Estimated<d>& e, const Scheme<d>& scheme, Where where) {
    report::SquaredError error;
    for (std::size_t i = 0; i < e.exact.size(); ++i) {
        if (where == Where::everywhere || e.inside[i]) error.add((e.*scheme.value)[i], e.exact[i]);
    }
    return error.relative();
}
template double value_error<1>(const Estimated<1>&, const Scheme<1>&, Where);
template double value_error<2>(const Estimated<2>&, const Scheme<2>&, Where);

template <int d>
double slope_error(const Estimated<d>& e, const Scheme<d>& scheme, Where where) {
    report::SquaredError error;
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

}  // namespace sph::consistency
