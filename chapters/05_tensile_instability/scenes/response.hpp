#pragma once
#include <array>
#include <vector>

#include "chapters/05_tensile_instability/scenes/cure_methods.hpp"

/// How a lattice answers when one particle is moved: all that its linear stability needs, for any method.
namespace sph::tensile {

/// The linear theory of a square lattice of per_side^2 particles, made numerically: each of one particle's
/// positions and velocities is changed a little, and its density where that evolves; the rates of all are
/// read. Every other particle's answer is the same, shifted; so waves do not mix, and the rates of a wave are
/// a 4 x 4 matrix (5 x 5 with a density), the Fourier transform of these answers.
class Response {
  public:
    /// Of a method at a pressure. The particles of the box, its jitter and its wave are not used: the lattice
    /// has 20 particles along each side. Throws Unstable where the rates are no numbers.
    Response(const CureMethod& method, double pressure);

    static constexpr int per_side = 20;
    /// The matrix of the wave k = 2 pi (wave_x, wave_y)/per_side, of (x, y, v_x, v_y, i rho) in rows; the
    /// last one is nothing where rho does not evolve.
    using Matrix = std::array<std::array<double, 5>, 5>;
    Matrix matrix(int wave_x, int wave_y) const;

    /// The fastest growth of all waves of the box   [c/dx]; below 0: all are damped.
    double growth() const;
    /// Speed of sound and of shear of the wave of 20 spacings along x   [c]; 0 where nothing swings.
    double sound_speed() const;
    double shear_speed() const;

  private:
    double speed(int axis) const;
    std::size_t states_ = 4;
    std::vector<Matrix> answers_;  // of the particle at (x, y) = (index % per_side, index / per_side)
};

}  // namespace sph::tensile
