#include "chapters/05_tensile_instability/scenes/modes.hpp"

namespace sph::tensile {
namespace {

/// The displacement's part along the wave, over that at the start.
double share(const LatticeBox& box, const Simulation<2>& liquid) {
    const auto& x = liquid.get<Position>();
    const Vector<2> k = box.k();
    double sum = 0, all = 0;
    for (std::size_t i = 0; i < box.size(); ++i) {
        const Vector<2> at = lattice_place(box, i);
        const double cosine = std::cos(dot(k, at - lattice_place(box, 0)));
        for (std::size_t a = 0; a < 2; ++a) {
            // A place at the box's edge may have been wrapped to the other side.
            const double moved = std::remainder(x[a][i] - at[a], box.side());
            sum += cosine * moved * box.wave.amplitude[a];
            all += square(cosine * box.wave.amplitude[a]);
        }
    }
    return sum / all;
}

/// Leapfrog makes of u'' = -omega^2 u the sequence cos(n a), or cosh(n a) where omega^2 < 0, exactly, with
/// 2 sin(a/2) = omega dt: so omega^2 follows from what u is after n steps.
double squared_frequency(double phase, bool grows, long steps, double dt) {
    const double half = phase / static_cast<double>(steps) / 2;
    return grows ? -square(2 / dt * std::sinh(half)) : square(2 / dt * std::sin(half));
}

}  // namespace

ModeRun run_mode(LatticeBox box) {
    constexpr double amplitude = 1e-6, grown = 3;
    const auto lattice = named_lattice<2>(box.kernel, box.h_over_dx);
    const Axes<2> axes = axes_of<2>(dispersion_matrix<2>(lattice, isotropic<2>(box.pressure), box.k()));
    box.wave.amplitude = amplitude * axes.direction[0];
    ModeRun run{.predicted = axes.value[0]};
    const auto liquid = liquid_box(box);
    double t = 0;
    march(*liquid, t, {.end = std::numeric_limits<double>::max(), .most_steps = 100000}, [&](double) {
        ++run.steps;
        const double now = share(box, *liquid);
        if (now > 0 && now < grown) return true;
        run.measured = squared_frequency(now > 1 ? std::acosh(now) : std::acos(std::max(now, -1.0)), now > 1,
                                         run.steps, box.courant);
        return false;
    });
    return run;
}

}  // namespace sph::tensile
