#pragma once
#include <string>
#include <vector>

#include "common/report/chapter.hpp"

namespace sph::euler {

/// The scene `dispersion` of the reader's own: CSV of omega^2 on standard output.
class DispersionCommand {
  public:
    void declare(app::CommandLine& line);
    void run(report::Run& run) const;

  private:
    std::string kernel_ = "cubic";
    double h_over_dx_ = 1.2, gamma_ = 5.0 / 3;
    std::vector<double> k_dx_{0.1, 0.2, 0.5, 1, 2, 3};
};

}  // namespace sph::euler
