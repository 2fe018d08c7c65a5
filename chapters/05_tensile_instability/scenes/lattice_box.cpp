#include "chapters/05_tensile_instability/scenes/lattice_box.hpp"

#include "chapters/01_kernel_interpolation/kernels.hpp"
#include "chapters/05_tensile_instability/lattice.hpp"

namespace sph::tensile {

double box_density(const std::string& kernel, double h_over_dx) {
    double rho = 0;
    const bool found = with_kernel<2>(kernel, [&](const auto& one) {
        rho = lattice_kernel<std::decay_t<decltype(one)>>(h_over_dx).density;
    });
    if (!found) throw std::invalid_argument{"no such kernel: " + kernel};
    return rho;
}

Liquid LatticeBox::state() const {
    return {pressure, 1, box_density(kernel, h_over_dx)};
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
        Vector<2> x = at + std::cos(dot(k, at)) * box.wave.amplitude;
        if (box.jitter > 0) {
            for (double& coordinate : x) coordinate += box.jitter * (2 * uniform() - 1);
        }
        space.wrap(x);
        simulation.place(i, x, std::cos(dot(k, at)) * box.wave.velocity_amplitude, 1, state.rho_0, state.P);
    }
}

}  // namespace sph::tensile
