#pragma once
#include <functional>
#include <string>
#include <vector>

#include "common/report/chapter.hpp"

/// Hard cases: which methods finish them.
namespace report {

/// A table of contestants against cases, "5/6", and bars of the share that each has finished.
class Survival {
  public:
    /// `with_total`: a last column with the sum over all cases.
    Survival(std::vector<std::string> cases, bool with_total);

    /// `attempt(k, r)` makes run r of `runs` of case k; it has failed if that throws app::UnphysicalError.
    /// Rows of results.csv: finished runs of "name case", and of "name all" with a total.
    void contestant(Run& run, const std::string& name, const std::string& label, std::size_t runs,
                    const std::function<void(std::size_t k, std::size_t r)>& attempt);

    std::string table() const { return table_.markdown(); }
    plot::Figure figure(const std::string& name) const;

  private:
    std::vector<std::string> cases_;
    bool with_total_;
    Table table_;
    std::vector<std::string> labels_;
    plot::Values shares_;  // [%]
};

}  // namespace report
