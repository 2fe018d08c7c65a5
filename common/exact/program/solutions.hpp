#pragma once
#include <memory>

#include "common/exact/program/solution.hpp"

/// The solutions that there are, each defined in the file of its name.
namespace exact::program {

std::unique_ptr<Solution> burgers();
std::unique_ptr<Solution> rarefaction();
std::unique_ptr<Solution> riemann();
std::unique_ptr<Solution> toy_star();

}  // namespace exact::program
