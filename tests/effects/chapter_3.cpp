// The effects of chapter 3: density, pressure and its work.
#include "tests/effects/subjects.hpp"

namespace sph::tested {

std::vector<Subject> chapter_3() {
    using enum Along;
    using enum Weight;
    const auto pushes = antisymmetric(mass, apart);
    const auto heats = neither(approach, "the pressure of i only: it gets its own share");
    const auto by_volume = neither(approach, "density of i, volume of j");
    return {
        of_gradients(NonConservingForce{},
                     {neither(apart, "the pressure of j only: with it the chapter begins")}),
        of_gradients(PressureForce<PhiIsDensity>{}, {pushes}),
        of_gradients(PressureForce<PhiIsOne>{}, {pushes}),
        of_gradients(PressureForce<PhiIsRootPressure>{}, {pushes}),
        of_gradients(GradHForce{}, {pushes}),
        of_gradients(CompressionHeating<PhiIsDensity>{}, {heats}),
        of_gradients(CompressionHeating<PhiIsOne>{}, {heats}),
        of_gradients(CompressionHeating<PhiIsRootPressure>{}, {symmetric_in_one_kernel(mass, approach)}),
        of_gradients(GradHHeating{}, {heats}),
        of_gradients(SharedHeating{}, {symmetric(mass, approach)}),
        of_gradients(Work{}, {antisymmetric(mass, nothing)}),
        of_gradients(Continuity<PhiIsDensity>{}, {symmetric_in_one_kernel(mass, approach)}),
        of_gradients(Continuity<PhiIsOne>{}, {by_volume}),
        of_gradients(Continuity<PhiIsRootPressure>{}, {by_volume}),
        of_gradients(PlainContinuity{}, {neither(nothing, "the velocity of j only")}),
        of_kernel(DensitySlope{}, {symmetric(mass, nothing)}),
        of_kernel(euler::TracerForce{.twice_K = 2}, {pushes}),
        of_kernel(euler::MomentumDensity{}, {neither(nothing, "the velocity of j only")}),
    };
}

}  // namespace sph::tested
