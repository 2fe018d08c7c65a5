#pragma once
#include "chapters/08_landau_model/scenes/slab.hpp"

namespace sph::landau {

/// Profiles of the slab by the recommended method over x >= 0 at the given times, and their errors as the
/// table of the name; returns the profiles. One thread: a line of particles is too short for two.
std::vector<SlabProfile> slab_profiles(report::Run& run, const std::string& name,
                                       const std::vector<double>& times);

/// Some hundred of the particles with x >= 0 as markers, in the k-th colour, labelled by their time.
void draw_right_half(plot::Panel& panel, const SlabProfile& profile, const Column& value, std::size_t k);

/// "$t$ = 2"
std::string at_time(double t);

}  // namespace sph::landau
