#pragma once
#include "chapters/02_consistency/scenes/measured.hpp"
#include "chapters/06_finite_particle_method/estimates.hpp"
#include "chapters/06_finite_particle_method/scenes/functions.hpp"

/// A function on particles, by a member of the family: how wrong value, slope and curvature are.
namespace sph::fpm {

using consistency::ParticleSet;

/// A member and the order of its series.
struct Choice {
    std::string member = "sfpm";
    int order = 2;
};

template <int d>
struct Interpolated {
    Columns<d> x;
    std::array<Column, derivatives<d>> exact, estimated;
    std::vector<bool> inside;  ///< farther than two supports from the ends
    Enlarged enlarged;
    Column condition;  ///< number of each neighbourhood, before any was enlarged
    std::size_t entries = 0;

    /// sqrt(sum (estimate - exact)^2 / sum exact^2) over all derivatives of that degree (0, 1, 2), of all
    /// particles or of those inside.
    double error(int degree, consistency::Where where) const;
    /// The same for first derivatives, of particles farther than `margin` from all faces; 0 <= margin < 1/2.
    double error_within(double margin) const;

  private:
    template <class Counts>
    double error_of(int degree, Counts&& counts) const;
};

/// d = 1, 2, 3. Second derivatives of members that have none of their own are their first ones taken twice
/// (1D only). Throws std::invalid_argument for a member or an order that is not there.
template <int d>
Interpolated<d> interpolate(const ParticleSet& set, const Smooth<d>& function, const Choice& choice);
extern template Interpolated<1> interpolate<1>(const ParticleSet&, const Smooth<1>&, const Choice&);
extern template Interpolated<2> interpolate<2>(const ParticleSet&, const Smooth<2>&, const Choice&);
extern template Interpolated<3> interpolate<3>(const ParticleSet&, const Smooth<3>&, const Choice&);

/// 1000 particles of the unit line, quintic spline, h = 0.002 = 2 dx; jittered: by up to 0.3 dx (Mota, Chen &
/// Qian 2017, figure 1).
ParticleSet thousand(Arrangement arrangement);

/// Many neighbourhoods of one kind: how many did not determine the fit at first, and at last.
struct Neighbourhoods {
    std::size_t count = 0;
    Enlarged enlarged;
    double slope_error = 0;  ///< of the wave, relative, over all of them
};
/// `sets` sets of n random particles on the unit line.
Neighbourhoods random_neighbourhoods(std::size_t sets, std::size_t n, double h_over_dx, const Choice& choice,
                                     const std::string& kernel, unsigned long seed);

}  // namespace sph::fpm
