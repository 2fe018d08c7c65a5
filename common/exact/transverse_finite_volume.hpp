#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "common/exact/relativistic_fluids.hpp"

namespace exact {

struct TransverseFiniteVolumeOptions {
    double tau0 = 1;       ///< at the start, > 0 [L]
    double courant = 0.5;  ///< share of a cell that the fastest wave may cross in a step, (0, 1]
    /// H >= 0 [1/L]: faces move at the velocities H r_0, at most 1, and stand at r_0 (1 + H (tau - tau0)).
    double expansion = 0;
};

/// A boost-invariant fluid of p = c2 eps in rings around the axis, at r = 0..end, by the MUSCL-Hancock scheme
/// of second order: RelativisticFiniteVolume's cells, faces and slopes in the coordinates (tau, r), where
///     d(tau r T01)/d tau + d(tau r T11)/dr = tau p,   d(tau r T00)/d tau + d(tau r T01)/dr = -r p.
/// The sources are the pressure at the middle of the step; a fluid without gradients keeps none. The axis is
/// a wall, and the last ring is continued outwards. Source: Chen (2017), eq. 269; the half step is
/// relativistic::Rates with v/r + 1/tau added to theta. Cost: about 30 nanoseconds a ring and step.
class TransverseFiniteVolume {
  public:
    /// `initial`: two rings or more, of equal width from r = 0 on. Throws std::domain_error, which names the
    /// value, for rings, fluid or options outside their ranges.
    TransverseFiniteVolume(const FluidCells& initial, const BaryonFreeFluid& fluid,
                           const TransverseFiniteVolumeOptions& options);

    /// Steps to proper time `tau` >= tau() exactly. Throws std::domain_error for an earlier one;
    /// UnphysicalCell where a ring has no pressure, which a shorter step does not cure.
    void advance_to(double tau);

    double tau() const noexcept { return tau_; }
    FluidCells cells() const;
    long steps() const noexcept { return steps_; }
    long cell_updates() const noexcept { return static_cast<long>(n_) * steps_; }

  private:
    using Values = BaryonFreeFluid::Values;

    double scale(double tau) const { return 1 + options_.expansion * (tau - options_.tau0); }
    double face(double i, double tau) const { return width_ * i * scale(tau); }
    double measure(std::size_t i, double tau) const;  ///< integral of tau r dr over ring i
    Values ring(std::ptrdiff_t i) const;              ///< also beyond the ends
    void predict(double dt);
    bool attempt(double dt);
    double fastest() const;  ///< largest speed of a wave in units of a ring's width

    BaryonFreeFluid fluid_;
    TransverseFiniteVolumeOptions options_;
    std::size_t n_;
    double width_;  ///< at tau0
    double tau_;
    long steps_ = 0;
    std::vector<Values> primitive_, next_, conserved_, west_, east_;
    std::vector<double> pressure_;  ///< at the middle of the step
};

/// Rings of 0..end with eps = 1 in r < radius, at rest; the ring at the edge holds its share. In the vacuum
/// eps = `outside`, as for half_slab(). end > radius > 0.
FluidCells disc(double radius, double end, std::size_t n, double outside = 1e-14);

}  // namespace exact
