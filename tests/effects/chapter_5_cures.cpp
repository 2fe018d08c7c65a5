// The effects of chapter 5's cures of the tensile instability.
#include "chapters/05_tensile_instability/cures.hpp"
#include "tests/effects/subjects.hpp"

namespace sph::tested {

std::vector<Subject> chapter_5_cures() {
    using enum Along;
    using enum Weight;
    return {
        of_kernel(ArtificialPressure{.below = 4}, {antisymmetric(mass, apart)}),
        of_kernel(ShareOfDifference{}, {neither(nothing, "P of i only")}),
        of_kernel(LinearExactForce{}, {antisymmetric(mass, nothing)}),
        of_kernel(BackgroundForce{.P_b = 1}, {antisymmetric(mass, apart), symmetric(mass, positive)}),
        of_kernel(TransportStress{}, {antisymmetric(mass, nothing)}),
        of_kernel(DisorderGradient{.R = 0.2}, {antisymmetric(volume, nothing)}),
    };
}

}  // namespace sph::tested
