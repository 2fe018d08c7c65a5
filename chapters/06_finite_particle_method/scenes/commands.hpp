#pragma once
#include "chapters/06_finite_particle_method/scenes/interpolation.hpp"
#include "common/report/chapter.hpp"

/// The scenes of the reader's own.
namespace sph::fpm {

/// `burgers`: the wave between 0 and 1 by any method. Leaves rows of results.csv, profile.csv (x,u,exact_u in
/// the order of labels) and a figure; warns of particles that have crossed.
class BurgersCommand {
  public:
    void declare(app::CommandLine& line);
    /// Throws app::UsageError for a method or ends that do not go with the motion, Unstable for a state that
    /// is not finite.
    void run(report::Run& run) const;

  private:
    std::string motion_ = "moving", method_, boundary_ = "mirror", kernel_;
    double viscosity_ = 0.01, time_ = 1, h_over_dx_ = std::nan("");
    long particles_ = 100;
};

/// `estimate`: a function on particles by one member. Leaves errors, profile.csv (position, value and
/// derivatives, estimated and exact) and a figure.
class EstimateCommand {
  public:
    void declare(app::CommandLine& line);
    /// Throws app::UsageError for an order or a number of particles that is not there.
    void run(report::Run& run) const;

  private:
    template <int d>
    void run_in(report::Run& run) const;

    std::string member_ = "sfpm", function_ = "two-gaussians", arrangement_ = "jittered", kernel_ = "quintic";
    long order_ = 2, dimension_ = 1, particles_ = 64;  // along each side
    double h_over_dx_ = 1.2, jitter_ = 0.2;
};

}  // namespace sph::fpm
