// The effect of chapter 6's remedies.
#include "chapters/06_finite_particle_method/keeping_apart.hpp"
#include "tests/effects/subjects.hpp"

namespace sph::tested {

std::vector<Subject> chapter_6() {
    using enum Along;
    using enum Weight;
    return {
        of_kernel(NearRepulsion{.q_0 = 1.2}, {antisymmetric(one, apart)}),
    };
}

}  // namespace sph::tested
