#pragma once
#include <functional>
#include <string>

/// Flows with boost invariance along z whose transverse part is known, as values.
namespace sph::transverse {

struct FlowState {
    double temperature = 0, u_r = 0;  ///< eps = s T, s = T^(1/c2)
};
using FlowProfile = std::function<FlowState(double r)>;

struct Flow {
    std::string name;
    double tau0 = 1, c2 = 1.0 / 3;
    double radius = 10;                       ///< of the disc that particles fill at tau0
    double window = 10;                       ///< errors are measured in r < window
    bool has_edge = false;                    ///< vacuum begins at the radius: the whole entropy is known
    std::function<double(double r)> spacing;  ///< where a graded spiral puts its particles
    FlowProfile start;                        ///< at tau0, for r <= radius
    /// Profiles of the cylinder are kept: a flow and its copies compute each tau once.
    std::function<FlowProfile(double tau)> exact;
};

/// T = 1 in r < R at rest at tau0, vacuum outside (Chen 2017, 5.1). R > 0, tau0 > 0, 0 < c2 < 1.
Flow cylinder(double R, double tau0, double c2);
/// Gubser's flow of size 1/q: particles fill r < 4/q, or 4 where that is more, errors are those in r < 2.5/q;
/// spacings grow as sqrt(1 + q^2 r^2), in proportion to the size over which the flow changes.
Flow gubser(double q, double tau0);

}  // namespace sph::transverse
