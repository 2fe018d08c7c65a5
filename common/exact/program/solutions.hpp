#pragma once
#include <memory>

#include "common/exact/program/solution.hpp"

/// The solutions that there are, each defined in the file of its name.
namespace exact::program {

std::unique_ptr<Solution> bar();
std::unique_ptr<Solution> beam();
std::unique_ptr<Solution> bjorken();
std::unique_ptr<Solution> burgers();
std::unique_ptr<Solution> gresho();
std::unique_ptr<Solution> gubser();
std::unique_ptr<Solution> landau();
std::unique_ptr<Solution> noh();
std::unique_ptr<Solution> oblique_shock();
std::unique_ptr<Solution> plate();
std::unique_ptr<Solution> prandtl_meyer();
std::unique_ptr<Solution> rarefaction();
std::unique_ptr<Solution> relativistic_riemann();
std::unique_ptr<Solution> riemann();
std::unique_ptr<Solution> sedov();
std::unique_ptr<Solution> shear_wave();
std::unique_ptr<Solution> taylor_green();
std::unique_ptr<Solution> toy_star();
std::unique_ptr<Solution> transverse();
std::unique_ptr<Solution> two_layer();
std::unique_ptr<Solution> woodward_colella();

}  // namespace exact::program
