#pragma once
#include "chapters/02_consistency/scenes/measured.hpp"

namespace sph::consistency {

/// What a set of particles on [0, 1] makes of the constant 1, at any place.
class EdgeLine {
  public:
    /// As `set` says, with the quintic spline and the volumes 1/N.
    explicit EdgeLine(const ParticleSet& set);
    const Column& particles() const& noexcept { return x_; }
    void particles() && = delete;  // what it refers to would be gone
    /// sum_j V_j W(x - x_j)   (m0 of moments.hpp at a place without a particle)
    double constant(double place) const;

  private:
    Column x_;
    double h_;
};

}  // namespace sph::consistency
