#pragma once
#include <vector>

#include "chapters/05_tensile_instability/scenes/lattice_growth.hpp"

/// Swegle's criterion beside the dispersion relation.
namespace sph::tensile {

/// One state of a lattice: does the criterion call it unstable, and how fast does it grow?
struct Verdict {
    std::string kernel;
    double h_over_dx, pressure;
    bool called = false;  ///< W'' sigma > 0 at the nearest neighbour   (Chen 2017, 64)
    double growth = 0;    ///< the fastest of all waves [c/dx]; a state with more than `least` is unstable

    static constexpr double least = 1e-6;
    bool unstable() const { return growth > least; }
    bool missed() const { return unstable() && !called; }
    bool false_alarm() const { return called && !unstable(); }
};

/// All kernels, with these h and pressures, on the lattice of d dimensions; states whose support ends before
/// the nearest neighbour are left out.
template <int d>
std::vector<Verdict> verdicts(const std::vector<double>& h_over_dx, const std::vector<double>& pressures);
extern template std::vector<Verdict> verdicts<1>(const std::vector<double>&, const std::vector<double>&);
extern template std::vector<Verdict> verdicts<2>(const std::vector<double>&, const std::vector<double>&);

}  // namespace sph::tensile
