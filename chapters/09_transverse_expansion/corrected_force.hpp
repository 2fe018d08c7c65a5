#pragma once
#include "chapters/04_artificial_viscosity/slopes.hpp"
#include "chapters/09_transverse_expansion/curved_fluid.hpp"

/// The same fluid with chapter 2's corrected gradient in the place of the Lagrangian's force.
namespace sph {

/// dq_i/dt = - (grad P~)_i/s*_i, with the gradient that is exact for linear functions (slopes.hpp). Forces of
/// i on j and of j on i are not opposite: momentum is not conserved.
struct CorrectedForce {
    using Uses = List<OfCurvedEntropy::Counted<SlopeMatrix>,
                      Renamed<SlopeSum<WeighedPressure>, As<Mass, Entropy>, As<Density, EntropyDensity>>>;
    using ReadsI = List<EntropyDensity>;
    using Writes = List<MomentumRate>;
    void finish(const auto& i, const auto& sum, auto& out) const {
        constexpr int d = static_cast<int>(std::decay_t<decltype(out.dq_dt)>::size());
        const auto& S = member<SlopeSum<WeighedPressure>, double, d>(sum);
        out.dq_dt = (-1 / i.s_star) * GuardedSolve{}(sum.M, S, 1.0);
    }
};

/// h as ConsistentH, without its force.
template <class K>
struct CorrectedH : ConsistentH<K, OfCurvedEntropy> {
    using ConsistentH<K, OfCurvedEntropy>::ConsistentH;
    using Force = CorrectedForce;
};

}  // namespace sph
