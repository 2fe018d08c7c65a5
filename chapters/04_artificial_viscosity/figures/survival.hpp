#pragma once
#include "common/report/chapter.hpp"

namespace sph::shocks {

/// Which methods finish the hard cases and are right, on even and on disordered particles.
class SurvivalFigure {
  public:
    void declare(app::CommandLine& line) {
        line.flag("all-runs", all_runs_, "both sizes and all disorders for every method; a minute");
    }
    void run(report::Run& run) const;

  private:
    bool all_runs_ = false;
};

}  // namespace sph::shocks
