#pragma once
#include "chapters/02_consistency/scenes/measured.hpp"
#include "common/report/chapter.hpp"

/// CPU nanoseconds a point of the schemes, for chapter 1's function with the quintic spline, which the passes
/// are compiled for: times are compared. One thread, the best of several samples; the particles are sorted
/// beforehand, and each evaluation looks for its neighbours.
namespace sph::consistency {

/// The slope by the scheme of that name: differences, cspm, linear or fit. d = 1, 2. Throws
/// std::invalid_argument for another name.
template <int d>
double slope_ns_per_point(report::Run& run, const std::string& scheme, const ParticleSet& set);
extern template double slope_ns_per_point<1>(report::Run&, const std::string&, const ParticleSet&);
extern template double slope_ns_per_point<2>(report::Run&, const std::string&, const ParticleSet&);

/// What may be listed together, in 2D.
struct ListedSchemes {
    std::string label;
    double (*ns_per_point)(report::Run& run, const ParticleSet& set);
};
const std::vector<ListedSchemes>& listed_schemes();

}  // namespace sph::consistency
