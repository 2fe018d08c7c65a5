#pragma once
#include "chapters/02_consistency/scenes/functions.hpp"

namespace sph::consistency {

/// What a scheme makes of a function with a jump.
struct JumpScheme {
    std::string name, label;
    Column value, slope;
};
/// Jittered particles of the unit interval, quintic spline, h = 1.2 dx: a function that jumps, exact and by
/// SPH, CSPM, DSPH and CSPM from one side.
struct JumpLine {
    double jump = 0;  ///< where it jumps
    Column x, exact, exact_slope;
    std::vector<JumpScheme> schemes;

    const JumpScheme& scheme(const std::string& name) const;
};
/// n particles; jitter in [spacings]. Throws std::invalid_argument if one side of the jump has no particles.
JumpLine line_with_jump(const Function<1>& function, double jump, std::size_t n, double jitter,
                        std::uint64_t seed, int threads);

/// Relative L2 errors of value and slope within `width` of the jump.
struct JumpErrors {
    double value = 0, slope = 0;
};
JumpErrors errors_near_jump(const JumpLine& line, const JumpScheme& scheme, double width);

}  // namespace sph::consistency
