// The effects of chapter 4: dissipation, with each viscosity, factor and speed of conduction.
#include "tests/effects/subjects.hpp"

namespace sph::tested {
namespace {

/// A viscosity resists approach and conserves momentum; its heat is half the work for each.
template <class Viscosity>
Subject force(const Viscosity& viscosity) {
    return of_gradients(ViscousForce<Viscosity>{viscosity}, {antisymmetric(Weight::mass, Along::apart)});
}
template <class Viscosity>
Subject heat(const Viscosity& viscosity) {
    return of_gradients(ViscousHeating<Viscosity>{viscosity}, {symmetric(Weight::mass, Along::approach)});
}

}  // namespace

std::vector<Subject> chapter_4() {
    using enum Along;
    using enum Weight;
    const auto conducts = antisymmetric(mass, more_u), rate = symmetric(one, positive);
    const PairwiseViscosity pairwise{.nu = 0.1};
    const StressViscosity stress{.nu = 0.1};
    const LayeredViscosity harmonic, arithmetic{.mean = MeanViscosity::arithmetic};
    return {
        force(BulkPressure{}),
        heat(BulkPressure{}),
        force(AlphaBeta{}),
        heat(AlphaBeta{}),
        force(SignalViscosity{}),
        heat(SignalViscosity{}),
        force(Scaled<SignalViscosity, ViscosityAlpha>{}),
        heat(Scaled<SignalViscosity, ViscosityAlpha>{}),
        force(Scaled<SignalViscosity, ShearFactor>{}),
        heat(Scaled<SignalViscosity, ShearFactor>{}),
        force(ReconstructedViscosity{}),
        heat(ReconstructedViscosity{}),
        of_gradients(ViscousForce<PairwiseViscosity>{pairwise}, {antisymmetric(mass, friction), rate}),
        of_gradients(ViscousHeating<PairwiseViscosity>{pairwise}, {symmetric(mass, positive)}),
        of_gradients(ViscousForce<LayeredViscosity>{harmonic}, {antisymmetric(mass, friction), rate}),
        of_gradients(ViscousHeating<LayeredViscosity>{harmonic}, {symmetric(mass, positive)}),
        of_gradients(ViscousForce<LayeredViscosity>{arithmetic}, {antisymmetric(mass, friction), rate}),
        of_gradients(ViscousHeating<LayeredViscosity>{arithmetic}, {symmetric(mass, positive)}),
        of_gradients(ViscousForce<StressViscosity>{stress}, {antisymmetric(mass, nothing), rate}),
        of_gradients(ViscousHeating<StressViscosity>{stress}, {neither(nothing, "the stress of i only")}),
        of_gradients(Conduction<SignalSpeed>{}, {conducts}),
        of_gradients(Conduction<SignalSpeedOfAll>{}, {conducts}),
        of_gradients(Conduction<OwnSpeed>{}, {conducts}),
        of_gradients(Conduction<ContactSpeed>{}, {conducts}),
        of_gradients(SignalRate{}, {rate}),
        of_gradients(SlopeMatrix{}, {symmetric_in_one_kernel(volume, positive)}),
        of_gradients(SlopeSum<MiddleVelocity>{}, {symmetric_in_one_kernel(volume, recession)}),
        of_gradients(SlopeSum<ThermalEnergy>{}, {symmetric_in_one_kernel(volume, uphill_u)}),
        of_gradients(SlopeSum<Pressure>{}, {symmetric_in_one_kernel(volume, uphill_p)}),
    };
}

}  // namespace sph::tested
