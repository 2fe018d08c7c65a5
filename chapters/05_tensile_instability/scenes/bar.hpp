#pragma once
#include <optional>
#include <string>

#include "common/core/vec.hpp"

/// The stressed bar of thesis figure 2: particles on a line between fixed ends, the middle one struck.
namespace sph::tensile {

enum class BarScheme { sph, cspm };

struct Bar {
    BarScheme scheme = BarScheme::sph;
    int particles = 41;  ///< free ones
    std::string kernel = "cubic";
    double h_over_dx = 1.2;
    double pressure = -0.2;  ///< [c^2 m/dx]; negative: tension
    double push = 1e-3;      ///< velocity of the middle particle at the start [c]
    double time = 60;        ///< [dx/c]
    double courant = 0.1;
    int threads = 1;
};

struct BarRun {
    Column t, u, exact;          ///< the middle particle's displacement [dx] and that of exact::StruckBar
    std::optional<double> lost;  ///< when a particle has moved by a tenth of a spacing; the run ends there
    double error() const;        ///< mean |u - exact| over the mean |exact|
};
/// Runge-Kutta of fourth order, whose error is below 1e-6 of the amplitude. Throws Unstable.
BarRun run_bar(const Bar& bar);

}  // namespace sph::tensile
