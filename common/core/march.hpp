#pragma once
#include <functional>
#include <limits>
#include <type_traits>

#include "common/core/stepper.hpp"

namespace sph {

/// How far to go, and by which steps.
struct StepControl {
    double end = std::numeric_limits<double>::infinity();
    /// > 0: so many steps, equal ones to `end`, or where that is infinite the stepper's own. 0: as few as the
    /// stepper allows.
    long steps = 0;
    long most_steps = std::numeric_limits<long>::max();  ///< a run that needs more is stopped as unstable
    int most_retries = 60;                               ///< of one step, each with half the length
    std::function<void(double share)> progress{};        ///< told after each step how much of the way is done
};

/// What a march has done.
struct Marched {
    long steps = 0, retries = 0;
    double seconds = 0;  ///< CPU time of all threads
};

namespace march_detail {
Marched march(Stepper& stepper, double& t, const StepControl& how, const std::function<bool(double)>& go_on);
}

/// Moves on from t to the end by steps as long as the stepper allows. A step that the stepper does not take
/// is tried again with half the length, at most `most_retries` times; what is left of the way is not cut into
/// a step and a crumb, but halved. Calls after_step(t) after each step; where it returns a bool, false ends
/// the march; an equal step that had to be taken in parts counts once, at its end. The only time loop of the
/// book: Ctrl-C is heard here, and progress told. Throws Unstable if a step stays too long, if there are too
/// many, and what the stepper throws.
template <class AfterStep>
Marched march(Stepper& stepper, double& t, const StepControl& how, AfterStep&& after_step) {
    return march_detail::march(stepper, t, how, [&](double now) {
        if constexpr (std::is_same_v<decltype(after_step(now)), bool>) {
            return after_step(now);
        } else {
            after_step(now);
            return true;
        }
    });
}
inline Marched march(Stepper& stepper, double& t, const StepControl& how) {
    return march_detail::march(stepper, t, how, [](double) { return true; });
}

}  // namespace sph
