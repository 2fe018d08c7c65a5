#pragma once
#include <functional>
#include <memory>
#include <string>

#include "common/core/motion.hpp"
#include "common/core/stepper.hpp"

/// Time integration. An integrator is given what evolves and a function rates(t), which fills the columns of
/// rates from the particles' present state; it allocates nothing after the first step. dt may be negative:
/// back in time.
namespace sph {

using Rates = std::function<void(double t)>;

class Integrator : public Stepper {
  public:
    Integrator(const Motion& motion, Rates rates) : motion_{&motion}, rates_{std::move(rates)} {}
    bool step(double& t, double dt) final;

  protected:
    virtual void advance(double& t, double dt) = 0;
    const Motion& motion() const { return *motion_; }
    void rates(double t) { rates_(t); }

  private:
    const Motion* motion_;
    Rates rates_;
};

/// Leapfrog, kick-drift-kick (Monaghan 2005, 5.51-5.53). Second order; symplectic and reversible where rates
/// depend on positions only. One evaluation of the rates a step: those of the end serve the next beginning,
/// unless restart() says that the state was changed in between.
class KickDriftKick : public Integrator {
  public:
    using Integrator::Integrator;
    void restart() override { has_rates_ = false; }

  private:
    void advance(double& t, double dt) override;
    bool has_rates_ = false;
};

/// Leapfrog, drift-kick-drift: Monaghan's Verlet (5.42-5.44). Second order; symplectic and reversible where
/// rates depend on positions only. One evaluation a step.
class DriftKickDrift : public Integrator {
  public:
    using Integrator::Integrator;

  private:
    void advance(double& t, double dt) override;
};

/// Predictor-corrector with one evaluation a step: everything is predicted to the middle with the rates of
/// the last middle, and advanced over the whole step with those found there. Second order for rates that
/// depend on anything (velocities, thermal energy).
class PredictorCorrector : public Integrator {
  public:
    using Integrator::Integrator;
    void restart() override { has_rates_ = false; }

  private:
    void advance(double& t, double dt) override;
    Motion::Saved start_;
    bool has_rates_ = false;
};

/// Runge-Kutta of second order (midpoint rule), two evaluations a step.
class RungeKutta2 : public Integrator {
  public:
    using Integrator::Integrator;

  private:
    void advance(double& t, double dt) override;
    Motion::Saved start_;
};

/// The classical Runge-Kutta method of fourth order, four evaluations a step.
class RungeKutta4 : public Integrator {
  public:
    using Integrator::Integrator;

  private:
    void advance(double& t, double dt) override;
    Motion::Saved start_, sum_;
};

/// How the two halves of a reversible step share the limit found in the middle.
enum class HalfSteps {
    arithmetic,  ///< dt_half = (dt_0 + dt_1) / 2     (Monaghan 2005, 5.49)
    harmonic     ///< 2 / dt_half = 1 / dt_0 + 1 / dt_1   (5.50)
};

/// Drift-kick-drift with a step that varies and can still be run backwards (5.45-5.48, with the factor 1/2
/// that 5.47 lacks as printed): the limit is taken in the middle, from positions, and symmetric in both
/// halves. A step begins with dt_0, the one before's dt_1, moves t by (dt_0 + dt_1)/2, and leaves its own
/// dt_1 as longest_step(). To go back, reverse the velocities and go on.
class ReversibleSteps : public Integrator {
  public:
    /// limit() is the step that the positions allow, called after rates(t) in the middle; `first` the first
    /// dt_0.
    ReversibleSteps(const Motion& motion, Rates rates, std::function<double()> limit, double first,
                    HalfSteps rule = HalfSteps::harmonic)
        : Integrator{motion, std::move(rates)}, limit_{std::move(limit)}, dt_{first}, rule_{rule} {}
    double longest_step() override { return dt_; }

  private:
    /// Throws Unstable if the limit changes so fast that dt_1 would not be positive.
    void advance(double& t, double dt) override;
    std::function<double()> limit_;
    double dt_;
    HalfSteps rule_;
};

}  // namespace sph
