#pragma once
#include "chapters/08_landau_model/scenes/slab.hpp"

namespace sph::landau {

/// Profiles of the slab by the recommended method over x >= 0 at the given times, and their errors; returns
/// the last error. One thread: a line of particles is too short for two.
double slab_profiles(report::Run& run, const std::string& name, const std::vector<double>& times);

/// "$t$ = 2"
std::string at_time(double t);

}  // namespace sph::landau
