#pragma once
#include <functional>
#include <string>
#include <vector>

#include "common/report/chapter.hpp"

/// Only what a scene lists: what each listed effect adds to the cost of a pair.
namespace report {

/// One pass over pairs with some effects listed, ready to be timed.
struct ListedPass {
    std::function<void()> pass;
    std::size_t particles = 0, pairs = 0;
    std::size_t columns = 0;  ///< that the particles hold for it
};

/// A table and bars of nanoseconds a pair.
class Prices {
  public:
    explicit Prices(bool with_columns) : with_columns_{with_columns} {}
    /// Times the pass. Rows of results.csv: cpu_ns_per_pair, and columns if they are shown.
    void add(Run& run, const std::string& label, const ListedPass& listed);
    std::string table() const;
    plot::Figure figure(const std::string& name, const std::string& title) const;

  private:
    bool with_columns_;
    std::vector<std::string> labels_;
    std::vector<std::size_t> columns_;
    plot::Values ns_;
};

}  // namespace report
