// The effects of chapter 9: chapter 3's, counted in entropy, with sqrt(-g) P for the pressure.
#include "chapters/09_transverse_expansion/curved_fluid.hpp"
#include "tests/effects/subjects.hpp"

namespace sph::tested {

std::vector<Subject> chapter_9() {
    using enum Along;
    using enum Weight;
    return {
        of_gradients(OfCurvedEntropy::Counted<PressureForce<>>{}, {antisymmetric(entropy, apart)}),
        of_gradients(OfCurvedEntropy::Counted<GradHForce>{}, {antisymmetric(entropy, apart)}),
    };
}

}  // namespace sph::tested
