#include "common/core/march.hpp"

#include <cmath>
#include <stdexcept>

#include "common/app/clock.hpp"
#include "common/app/program.hpp"
#include "common/core/unstable.hpp"

namespace sph {
namespace {

/// Takes one step of dt, or of dt/2, dt/4, ...; returns how often it was halved.
int step_with_retries(Stepper& stepper, double& t, double dt, int most_retries) {
    for (int retry = 0;; ++retry) {
        require_time_step(t, dt);
        if (stepper.step(t, dt)) return retry;
        if (retry == most_retries)
            throw Unstable{t, Unstable::no_particle,
                           "the time step after " + std::to_string(most_retries) + " halvings", dt};
        dt /= 2;
    }
}

}  // namespace

Marched march_detail::march(Stepper& stepper, double& t, const StepControl& how,
                            const std::function<bool(double)>& go_on) {
    const bool endless = std::isinf(how.end), equal = how.steps > 0 && !endless;
    if (endless && how.steps == 0) throw std::invalid_argument{"march: neither an end nor a number of steps"};
    const double start = t, equal_step = equal ? (how.end - start) / static_cast<double>(how.steps) : 0;
    constexpr double rounding = 1 + 1e-12;  // what is left after halving may miss the limit by as much
    const double begin = app::process_cpu_seconds();
    Marched done;
    double rest = equal_step;  // of an equal step that was taken in parts
    while (how.steps > 0 ? done.steps < how.steps : t < how.end) {
        app::check_interrupt();
        if (done.steps == how.most_steps)
            throw Unstable{t, Unstable::no_particle, "the number of steps",
                           static_cast<double>(how.most_steps)};
        const double before = t, left = how.end - t;
        const double allowed = equal ? rest : stepper.longest_step();
        if (std::isnan(allowed)) throw Unstable{t, Unstable::no_particle, "the time step", allowed};
        const bool last = !equal && left <= allowed * rounding;
        const double wanted = equal || left >= 2 * allowed ? allowed : last ? left : left / 2;
        const int retries = step_with_retries(stepper, t, wanted, how.most_retries);
        if (last && retries == 0) t = how.end;
        done.retries += retries;
        if (equal && retries > 0) {
            rest -= t - before;
            continue;
        }
        rest = equal_step;
        ++done.steps;
        if (how.progress)
            how.progress(how.steps > 0 ? static_cast<double>(done.steps) / static_cast<double>(how.steps)
                                       : (t - start) / (how.end - start));
        if (!go_on(t)) break;
    }
    done.seconds = app::process_cpu_seconds() - begin;
    return done;
}

}  // namespace sph
