#pragma once
#include "chapters/04_artificial_viscosity/scenes/tube_command.hpp"
#include "chapters/07_godunov_sph/scenes/godunov_methods.hpp"

/// The scenes of the reader's own.
namespace sph::godunov {

/// Chapter 4's tube with this chapter's methods.
shocks::TubeKind tube_kind();

/// A standing sound wave of amplitude 1e-6 for one period. Leaves rows of results.csv, profile.csv
/// (x,v,exact_v, at the period's end) and the figure "wave".
class WaveOfSound {
  public:
    WaveOfSound();
    void declare(app::CommandLine& line);
    void run(report::Run& run) const;

  private:
    report::MethodOptions<Method<1>> method_;
    long particles_ = 64;
    double courant_ = 0.45;
};

}  // namespace sph::godunov
