#pragma once
#include "chapters/03_euler_sph/scenes/methods.hpp"
#include "common/core/dense.hpp"
#include "common/exact/toy_star.hpp"
#include "common/report/chapter.hpp"

/// A toy star in one dimension (Monaghan 2005, sections 6.2-6.3): gas held together by a linear force. At
/// rest its radius, its central density and Omega are 1, rho^(gamma - 1) = 1 - x^2.
namespace sph::euler {

/// How the particles of the star at rest are spaced.
enum class Spacing {
    even,    ///< the same spacing everywhere, masses that vanish at the edge
    graded,  ///< half way from even spacing to one in proportion to the speed of sound, finest at the edge
    masses   ///< equal masses: the spacing grows towards the edge
};

struct StarScene {
    std::size_t n = 400;
    double gamma = 2;  ///< > 1
    Spacing spacing = Spacing::graded;
    int threads = 1;
    std::function<void(double)> progress{};

    Polytrope state() const { return {(gamma - 1) / (2 * gamma), gamma}; }
    double mean_spacing() const { return 2.0 / static_cast<double>(n); }
    /// The exact star that starts with v = A_0 x.
    exact::ToyStar exact(double A_0) const { return {gamma, state().K, 1, A_0, 1, 1}; }
};

/// Where the particles are put, and their masses: those of the exact star between the midpoints of the
/// spacing's coordinate.
struct StarPoints {
    Column x, m, width;
};
StarPoints star_points(const StarScene& scene);

/// Puts a star's particles at the places of the exact solution, nearly at rest.
void fill_star(LineGas& gas, const StarScene& scene);
std::unique_ptr<LineGas> star_gas(const StarScene& scene, const GasMethod& method);

/// d a_i/d x_j of a gas in one dimension, by central differences.
/// Cost: two evaluations of the rates a particle.
Dense jacobian(LineGas& gas);
/// Brings the star to rest by Newton's method. A step moves no two neighbours more than 0.4 of their distance
/// together. Returns the Jacobian at rest. Throws Unstable if there is no equilibrium near the exact one.
Dense relax(LineGas& gas);

/// `courant` times the least spacing/c_s of the particles at their present densities.
double star_step(const LineGas& gas, const StarScene& scene, double courant);

/// Frequencies of the linear modes 1..`modes` of the discrete star at rest, without waiting for it to
/// oscillate: it is brought to rest by Newton's method, and the eigenvalues of its Jacobian are -omega^2.
/// Throws what relax() throws.
std::vector<double> star_frequencies(const StarScene& scene, const GasMethod& method, int modes);

/// Omega (5.7) of the particles of the relaxed star, with own h.
Column star_omega(const StarScene& scene, const GasMethod& method);

/// What a star that oscillates leaves.
struct StarRun {
    double omega = 0;      ///< of the mode, measured over a few periods
    Column x, v, exact_v;  ///< at the end
};
/// One linear mode by RK4 over `periods` + 1 periods: its velocity is the exact eigenfunction at t = 0, and
/// its frequency that of the part of the velocity that is this mode.
/// `phase_step`: largest phase of the mode in a time step; RK4 shifts omega by its fourth power over 120.
StarRun run_mode(const StarScene& scene, const GasMethod& method, int mode, int periods,
                 double phase_step = 0.1);

/// The nonlinear oscillation v = A(t) x (6.18-6.19) from the state at rest with v = A_0 x.
struct NonlinearRun {
    Column t, radius, exact_radius, energy;  ///< energy: its change, relative
    double radius_error = 0;                 ///< largest, relative
    double velocity_error = 0;               ///< relative L1 of v at the end
    double energy_drift = 0, momentum = 0;
    double seconds = 0;  ///< CPU time of the oscillation, without the rest before it
    Counters counters;
    Column x, rho, v, exact_rho, exact_v;  ///< at the end

    report::Quantities measured() const;
};
/// Leapfrog from the relaxed star over `time`. radius: from the second moment of the mass.
NonlinearRun run_nonlinear(const StarScene& scene, const GasMethod& method, double A_0, double time,
                           double courant = 0.3);

/// The scene `star` of the reader's own.
class StarCommand {
  public:
    void declare(app::CommandLine& line);
    void run(report::Run& run) const;

  private:
    MethodChoice choice_;
    std::string spacing_ = "graded";
    double gamma_ = 5.0 / 3, amplitude_ = 0.5, time_ = 5;
    long particles_ = 100;
};

}  // namespace sph::euler
