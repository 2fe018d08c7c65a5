#pragma once
#include "chapters/05_tensile_instability/scenes/solid.hpp"

/// The two kinds of solids, compiled apart: make_solid() chooses.
namespace sph::tensile {

std::unique_ptr<Solid> make_jaumann_solid(const SolidSetup& setup, const SolidMethod& method);
std::unique_ptr<Solid> make_lagrangian_solid(const SolidSetup& setup, const SolidMethod& method);

}  // namespace sph::tensile
