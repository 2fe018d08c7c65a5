#pragma once
#include "chapters/01_kernel_interpolation/scenes/options.hpp"

namespace sph::interpolation {

/// The scene `interpolate` of the reader's own: the test function at particles of any kind. Leaves errors,
/// profile.csv and a figure.
class InterpolateCommand {
  public:
    void declare(app::CommandLine& line);
    void run(report::Run& run) const;

  private:
    template <int d>
    void run_in(report::Run& run) const;

    ParticleOptions options_;
    long dimension_ = 1;
    std::string arrangement_ = "jittered";
};

}  // namespace sph::interpolation
