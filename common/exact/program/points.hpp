#pragma once
#include <string>
#include <vector>

#include "common/app/command_line.hpp"

namespace exact::program {

/// Where a solution is wanted: `--x LIST`, or `--points N --window a,b` for N equidistant points.
class Points {
  public:
    /// `name` of the coordinate and of the option of its list, "x" or "r"; `range` of its values; `window`,
    /// the default of --window: its two ends.
    Points(std::string name, app::Range range, std::vector<double> window);

    void declare(app::CommandLine& command, const std::string& meaning);

    /// The list as it was given, or the N points of the window, both its ends included.
    /// Throws app::UsageError unless exactly one of the two was given, or if the window's ends do not
    /// increase.
    std::vector<double> values(const app::CommandLine& command) const;

  private:
    std::string name_;
    app::Range range_;
    std::vector<double> window_;
    std::vector<double> list_;
    long count_ = 2;
};

}  // namespace exact::program
