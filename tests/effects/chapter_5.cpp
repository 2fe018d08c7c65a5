// The effects of chapter 5: elastic solids.
#include "tests/effects/subjects.hpp"

namespace sph::tested {

std::vector<Subject> chapter_5() {
    using enum Along;
    using enum Weight;
    const auto momentum = antisymmetric(mass, nothing), slope = symmetric_in_one_kernel(volume, nothing);
    return {
        of_kernel(DeformationRate{}, {symmetric_in_one_kernel(volume, recession)}),
        of_kernel(StressForce{}, {momentum}),
        of_kernel(ArtificialStressForce{.W_dx = 0.4}, {momentum}),
        of_kernel(Xsph{.epsilon = 0.5}, {antisymmetric(mass, friction)}),
        of_kernel(DisplacementGradient{}, {slope}),
        of_kernel(ReferenceForce{}, {momentum}),
        of_kernel(HourglassForce{.stiffness = 1}, {momentum}),
    };
}

}  // namespace sph::tested
