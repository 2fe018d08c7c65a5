#pragma once
#include "chapters/02_consistency/scenes/options.hpp"

namespace sph::consistency {

/// The scene `interpolate` of the reader's own: a function on particles of any kind by every scheme. Leaves
/// errors, profile.csv and a figure.
class SchemesCommand {
  public:
    void declare(app::CommandLine& line);
    /// Throws app::UsageError for too many particles in 2D.
    void run(report::Run& run) const;

  private:
    template <int d>
    void run_in(report::Run& run) const;

    ParticleSetOptions options_;
    long particles_ = 64;  // along each side of the box
    long dimension_ = 1;
    std::string arrangement_ = "jittered";
    std::string function_ = "wave";
};

}  // namespace sph::consistency
