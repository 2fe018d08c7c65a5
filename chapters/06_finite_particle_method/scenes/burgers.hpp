#pragma once
#include <functional>

#include "chapters/06_finite_particle_method/moving_frame.hpp"
#include "common/report/chapter.hpp"

/// Burgers' equation between x = 0 and 1, u = sin(pi x) at t = 0, u = 0 at the ends, by every method.
namespace sph::fpm {

enum class Moving {
    still,
    with_u,
    with_smoothed_u,
    shifted,
    repelled,
    remeshed_by_fit,
    remeshed_by_sharing,
    to_wanted_places
};

struct BurgersScene {
    std::size_t n = 100;      ///< particles between the ends
    double viscosity = 0.01;  ///< gamma [length^2/time]
    double time = 1;          ///< end
    Moving moving = Moving::still;
    Ends ends = Ends::mirror;
    std::string estimate = "sfpm";  ///< a member of the family, "fdm" for differences
    int order = 2;
    std::string kernel = "quintic";
    double h_over_dx = 1;
    double length = 1;        ///< of the line, with mirrors at both ends; 1, or 2 for Ye's figure 5
    double perturbation = 0;  ///< largest random change of x [spacings] and of u [its amplitude/10]
    double jitter = 0;        ///< largest random shift of still particles, but those at the ends [spacings]
    unsigned long seed = 1;
    long steps = 0;               ///< > 0: so many equal steps
    double step_factor = 1;       ///< times the usual step
    std::vector<double> looks{};  ///< times at which errors are measured, beside the end
    bool stops_at_crossing = false;
    bool keeps_paths = false;  ///< of all particles, at each step
    std::function<void(double)> progress{};

    double dx() const;
};

/// Errors at one time, over the labelled particles: sum |u - exact| / sum |exact|, and the largest |u -
/// exact| over the largest |exact|.
struct ErrorsAt {
    double t = 0, l1 = 0, linf = 0;
};
struct BurgersRun {
    Column x, u, exact;  ///< in the order of labels, at the end
    std::vector<ErrorsAt> errors;
    double worst_l1 = 0, worst_linf = 0;  ///< over all looks
    double relative = 0;  ///< P of (Ye et al. 2019, 23), at seven places; NaN unless particles stand there
    long steps = 0, remeshings = 0, evaluations = 0;
    std::size_t crossed = 0, most_crossed = 0;  ///< neighbours in the wrong order: at the end, and the most
    double first_crossing = -1;                 ///< time; -1: never
    double stopped = -1;  ///< time at which try_burgers() found the state unphysical; -1: never
    double mass_change = 0, momentum_change = 0;  ///< by remeshing, relative to what there was at t = 0
    Enlarged enlarged;
    double seconds = 0;  ///< CPU time of the steps
    Column path_t;
    std::vector<Column> path_x, path_u;  ///< [step][label]

    report::Quantities measured() const;
};

/// Runs it. Throws Unstable for a state that is not finite, std::invalid_argument for a scene that has no
/// meaning (differences that move, a frame without mirrors).
BurgersRun run_burgers(const BurgersScene& scene);

/// The same, but where run_burgers() would throw Unstable, what there was until then.
BurgersRun try_burgers(const BurgersScene& scene);

/// One evaluation of the rates at the start, rows found anew as for particles that move (with u, if the scene
/// has them stand still); for differences, which have theirs, only applied.
std::function<void()> rates_of(const BurgersScene& scene);
/// What the rows of these rates take in memory, for each particle.
double bytes_of_rows(const BurgersScene& scene);

/// The position at time t of the fluid element that began at X: dx/dt = u, by the exact u.
Column exact_path(double viscosity, double X, const Column& times);

}  // namespace sph::fpm
