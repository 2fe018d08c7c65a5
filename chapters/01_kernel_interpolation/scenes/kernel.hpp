#pragma once
#include "common/report/chapter.hpp"

namespace sph::interpolation {

/// The scene `kernel` of the reader's own: W, its derivatives and F against q as CSV on standard output.
class KernelCommand {
  public:
    void declare(app::CommandLine& line);
    void run(report::Run& run) const;

  private:
    std::string kernel_ = "cubic";
    long dimension_ = 1;
};

}  // namespace sph::interpolation
