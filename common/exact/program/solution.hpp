#pragma once
#include <memory>
#include <string>
#include <vector>

#include "common/app/command_line.hpp"

namespace exact::program {

/// One solution of the program `exact`: its name, its options, and its values as CSV. A new one is a file
/// beside burgers.cpp that defines a class of this kind, and a line in solutions.cpp.
class Solution {
  public:
    virtual ~Solution() = default;

    virtual std::string name() const = 0;  ///< the word of the command line, "burgers"
    virtual std::string description() const = 0;

    /// Declares the options; their values go into the solution's own members.
    virtual void declare(app::CommandLine& command) = 0;

    /// The lines to print, once the options that `declare` put into `command` have been parsed.
    /// Throws app::UsageError for options that do not go together.
    virtual std::string csv(const app::CommandLine& command) const = 0;
};

/// All solutions, in the order in which --help lists them.
std::vector<std::unique_ptr<Solution>> solutions();

}  // namespace exact::program
