#pragma once
#include "common/core/vec.hpp"
#include "common/plot/figure.hpp"

/// Maps and profiles of what happens around the origin of a plane.
namespace sph::shocks {

struct PlaneField {
    const Columns<2>& x;
    const Column& r;
    const Column& rho;
};
/// The density in 0 <= x, y <= side, in colours up to `highest`.
void draw_map(plot::Panel& panel, const PlaneField& field, double side, double highest, double diameter);
/// The density against r up to r_end: means over rings, by particles, with their standard deviation as bars.
void draw_profile(plot::Panel& panel, const PlaneField& field, double r_end, const plot::Style& look);

}  // namespace sph::shocks
