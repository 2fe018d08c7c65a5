// Compiled by a test, with and without the column that the effect reads.
#include "tests/common/core/test_kernel.hpp"

#ifdef COMPLETE
using Scene = sph::Particles<2, sph::Position, sph::Mass, sph::Acceleration, sph::Pressure>;
#else
using Scene = sph::Particles<2, sph::Position, sph::Mass, sph::Acceleration>;
#endif

int main() {
    Scene particles{10};
    sph::Neighbours<2> neighbours;
    neighbours.find(particles.x, 1);
    sph::sum_over_neighbours(particles, neighbours, test::Constant{1}, sph::Effects{test::PressureForce{}});
}
