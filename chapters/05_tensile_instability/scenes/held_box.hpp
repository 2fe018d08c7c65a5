#pragma once
#include "chapters/05_tensile_instability/scenes/lattice_box.hpp"

/// The box of thesis figure 1: fixed particles around free ones, under tension, and a push at one of them.
namespace sph::tensile {

struct HeldBox {
    std::size_t free_side = 20;  ///< free particles along each side
    std::size_t layers = 5;      ///< of fixed ones: two reaches, so that all that free ones see is complete
    std::string kernel = "cubic";
    double h_over_dx = 1.2;
    double pressure = -0.2;  ///< [c^2 m/dx^2]
    double push = 1e-3;      ///< velocity of the particle in the middle at the start [c]
    double shown = 20;       ///< the state at this time is kept [dx/c]: sound has crossed the free inside
    double time = 40;        ///< [dx/c]
    double courant = 0.2;
    int threads = 1;

    std::size_t side() const { return free_side + 2 * layers; }
};

struct HeldBoxRun {
    Columns<2> shown, fixed;  ///< the free particles at the time `shown`, and those that are held
    Column moved;             ///< the free ones' distance from their places then [dx]
    double nearest = 0;       ///< then: the smallest distance between two free particles [dx]
    Column t, farthest;       ///< the largest distance from its place that a particle has, over time [dx]
    double clumped_at = 0;    ///< when a particle was half a spacing from its place first; 0: never
};
/// Throws Unstable.
HeldBoxRun run_held_box(const HeldBox& scene);

}  // namespace sph::tensile
