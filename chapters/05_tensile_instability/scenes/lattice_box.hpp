#pragma once
#include <memory>
#include <string>

#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "chapters/05_tensile_instability/liquid.hpp"
#include "common/core/arrangement.hpp"

/// A periodic box of a liquid on a square lattice, in units where the spacing, the speed of sound and the
/// particles' mass are 1: the scene of this chapter's theory and of its cures.
namespace sph::tensile {

/// One wave of displacements: x_i += amplitude cos(k . (x_i - x_0)), k = 2 pi waves/per_side, with a crest at
/// the first particle.
struct LatticeWave {
    std::array<int, 2> waves{};      ///< wave lengths in the box, along x and y
    Vector<2> amplitude{};           ///< [spacings]
    Vector<2> velocity_amplitude{};  ///< [c]: v_i = velocity_amplitude cos(k . (x_i - x_0))
};

struct LatticeBox {
    std::size_t per_side = 20;     ///< particles along each side
    std::string kernel = "cubic";  ///< one of kernel_names()
    double h_over_dx = 1.2;
    double pressure = -0.2;  ///< on the lattice [c^2 m/dx^2]; negative: tension
    double jitter = 0;       ///< each coordinate shifted at random by up to so many spacings
    std::uint64_t seed = 1;
    LatticeWave wave{};
    double courant = 0.2;  ///< time step [dx/c]
    int threads = 1;

    std::size_t size() const { return per_side * per_side; }
    double side() const { return static_cast<double>(per_side); }
    Vector<2> k() const {
        const double k_1 = 2 * pi / side();
        return {k_1 * wave.waves[0], k_1 * wave.waves[1]};
    }
    Box<2> box() const { return {{0, 0}, {side(), side()}, Face::periodic}; }
    /// p = pressure at the density that the lattice has by summation.
    Liquid state() const;
    FixedH<AnyKernel<2>> resolution() const { return {h_over_dx, AnyKernel<2>{kernel}}; }
};

/// The lattice's place of particle i, before jitter and wave.
Vector<2> lattice_place(const LatticeBox& box, std::size_t i);

/// Writes the scene's positions, velocities, masses, density and pressure.
void place(const LatticeBox& box, Simulation<2>& simulation);

/// The liquid in that box, with a cure, placed and started, with steps of `courant`.
template <class Cure = Uncured>
std::unique_ptr<CuredLiquid<FixedH<AnyKernel<2>>, Box<2>, Cure>> liquid_box(const LatticeBox& box,
                                                                            Cure cure = {}) {
    using One = CuredLiquid<FixedH<AnyKernel<2>>, Box<2>, Cure>;
    auto liquid = std::make_unique<One>(box.size(), box.resolution(), box.state(), box.box(), box.threads,
                                        std::move(cure));
    place(box, *liquid);
    liquid->limit_steps([dt = box.courant] { return dt; });
    liquid->start(0);
    return liquid;
}

}  // namespace sph::tensile
