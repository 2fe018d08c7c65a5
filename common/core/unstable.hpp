#pragma once
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "common/app/error.hpp"

namespace sph {

/// A simulation has left physics: a state that is not finite, a density or energy that is not positive, a
/// time step that has collapsed. Ends a program with exit status 3.
struct Unstable : app::UnphysicalError {
    static constexpr std::size_t no_particle = std::numeric_limits<std::size_t>::max();

    double time;
    std::size_t particle;  ///< no_particle where the quantity is not one particle's
    std::string quantity;
    double value;

    Unstable(double time, std::size_t particle, std::string quantity, double value);
    /// The same, at another time: who finds a failure need not know the time.
    Unstable at(double when) const { return {when, particle, quantity, value}; }
};

/// Throws Unstable for the first of the particles' values that is not finite, or not > 0 if `positive`.
/// Cost: one pass over the values.
void require_physical(std::span<const double> values, std::string_view quantity, bool positive, double t);

/// Throws Unstable unless `dt` still moves the time on.
void require_time_step(double t, double dt);

/// Throws Unstable at time t unless x[0] < x[1] < ...: particles on a line must not overtake each other.
void require_order(std::span<const double> x, double t);

}  // namespace sph
