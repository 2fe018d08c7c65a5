#include "chapters/05_tensile_instability/scenes/lattice_box.hpp"

#include "chapters/05_tensile_instability/scenes/lattice_growth.hpp"

namespace sph::tensile {

Liquid LatticeBox::state() const {
    return {pressure, 1, named_lattice<2>(kernel, h_over_dx).density};
}

Vector<2> lattice_place(const LatticeBox& box, std::size_t i) {
    return {static_cast<double>(i % box.per_side) + 0.5, static_cast<double>(i / box.per_side) + 0.5};
}

void place(const LatticeBox& box, Simulation<2>& simulation) {
    const Liquid state = box.state();
    const Box<2> space = box.box();
    const Vector<2> k = box.k();
    Uniform uniform{box.seed};
    for (std::size_t i = 0; i < box.size(); ++i) {
        const Vector<2> at = lattice_place(box, i);
        const double crest = std::cos(dot(k, at - lattice_place(box, 0)));
        Vector<2> x = at + crest * box.wave.amplitude;
        if (box.jitter > 0) {
            for (double& coordinate : x) coordinate += box.jitter * (2 * uniform() - 1);
        }
        space.wrap(x);
        simulation.place(i, x, crest * box.wave.velocity_amplitude, 1, state.rho_0, state.P);
    }
}

}  // namespace sph::tensile
