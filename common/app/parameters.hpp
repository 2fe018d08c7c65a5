#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "common/app/command_line.hpp"

namespace app {

/// A number that a user may change: "alpha", 0..10, "strength of the linear term".
struct Parameter {
    std::string name;
    double value = 0;
    Range range = any;
    std::string meaning;
};

/// The parameters of one thing, each name once, in the order in which they were added.
class Parameters {
  public:
    /// The first of a name counts: a part that shares a parameter with an earlier one has its value.
    void add(const Parameter& parameter);
    const std::vector<Parameter>& list() const& noexcept { return list_; }
    void list() && = delete;  // what it refers to would be gone
    bool has(std::string_view name) const;
    /// Throws std::out_of_range naming one that is not there.
    double value(std::string_view name) const;
    /// Throws UsageError naming the parameter, the value and the allowed range.
    void set(std::string_view name, double value);

  private:
    const Parameter* find(std::string_view name) const;
    std::vector<Parameter> list_;
};

}  // namespace app
