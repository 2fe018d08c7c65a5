#pragma once
#include <limits>

namespace sph {

/// Something that moves on in time by steps; march() repeats them.
class Stepper {
  public:
    Stepper() = default;
    Stepper(const Stepper&) = delete;
    Stepper& operator=(const Stepper&) = delete;
    virtual ~Stepper() = default;

    /// The longest step that the present state allows; infinite where nothing limits it.
    virtual double longest_step() { return std::numeric_limits<double>::infinity(); }
    /// One step from t to t + dt. False: it must be shorter, and all is as before. Throws Unstable when the
    /// new state has lost its meaning, or when dt no longer moves t on.
    virtual bool step(double& t, double dt) = 0;
    /// Calls the steps before the next one did not see: the state was changed from outside.
    virtual void restart() {}
};

}  // namespace sph
