#include "chapters/07_godunov_sph/godunov_force.hpp"
#include "tests/effects/subjects.hpp"

namespace sph::tested {

// The force itself takes a kernel of its own, and is tested with it: tests/07_godunov_sph.
std::vector<Subject> chapter_7() {
    return {of_gradients(ClosingRate{}, {symmetric(Weight::one, Along::positive)})};
}

}  // namespace sph::tested
