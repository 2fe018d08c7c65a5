#pragma once
#include "common/plot/figure.hpp"

namespace plot {

/// The colour of the map at `t` in 0..1; values outside are clamped, alpha is 1. Interpolated linearly in
/// sRGB between stops of the published 256-entry tables, within 1.5/255 of each entry. Sources: viridis,
/// magma (Smith, van der Walt 2015, CC0), cividis (Nunez, Anderton, Renslow 2018, CC0), blue_red: smooth
/// cool-warm (Moreland 2009, doi 10.1007/978-3-642-10520-3_9), its 33-entry table.
Colour map_colour(Map map, double t);

/// Where `value` lies on a colour bar's range, 0 at its low end and 1 at its high end (not clamped).
double map_position(double value, const std::array<double, 2>& range, Scale scale);

/// Relative luminance, 0 (black) to 1 (white), by the sRGB transfer function (IEC 61966-2-1).
double luminance(const Colour& colour);

/// (1 - t) a + t b, each component; t in 0..1.
Colour mixed(const Colour& a, const Colour& b, double t);
/// The same colour with another opacity.
Colour faded(const Colour& colour, double alpha);

}  // namespace plot
