#pragma once
#include "common/report/chapter.hpp"

namespace sph::interpolation {

/// Estimates that are listed together, and what their pass costs in CPU nanoseconds a point: cubic spline,
/// jittered particles of the unit square. The pass is compiled for this kernel: times are compared.
struct ListedEstimates {
    static constexpr std::size_t per_side = 48;
    std::string name;
    double (*ns_per_point)(report::Run& run, double h_over_dx);
};
/// From one estimate to all of them.
const std::vector<ListedEstimates>& listed_estimates();

}  // namespace sph::interpolation
