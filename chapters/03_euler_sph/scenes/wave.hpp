#pragma once
#include <numbers>

#include "chapters/03_euler_sph/scenes/methods.hpp"
#include "common/report/chapter.hpp"

/// A standing sound wave in a periodic line of gas with rho = 1, c_s = 1.
namespace sph::euler {

struct WaveScene {
    std::size_t n = 64;       ///< particles
    double gamma = 1.4;       ///< adiabatic index
    double amplitude = 1e-7;  ///< of the velocity [c_s]
    int waves = 1;            ///< wave lengths in the box of length 1
    double periods = 1;       ///< how long it runs
    double courant = 0.3;     ///< time step [spacing/c_s]
    int threads = 1;
    double density = 1;  ///< where the speed of sound is 1
    std::function<void(double)> progress{};

    double spacing() const { return 1.0 / static_cast<double>(n); }
    double k() const { return 2 * std::numbers::pi * waves; }
    Polytrope state() const { return {std::pow(density, 1 - gamma) / gamma, gamma}; }
    /// v(x, t) of the linear wave; exact to second order in the amplitude.
    double velocity(double x, double t) const { return amplitude * std::cos(k() * t) * std::sin(k() * x); }
};

/// The gas of a wave at t = 0: even particles, all their energy in motion.
std::unique_ptr<LineGas> wave_gas(const WaveScene& scene, const GasMethod& method);

/// What a run of a wave leaves.
struct WaveRun {
    double error = 0;  ///< largest over the run of sum |v - v_exact| / sum of its amplitude
    double energy_drift = 0, momentum_drift = 0;  ///< largest, relative to the wave's energy, m c_s amplitude
    double seconds = 0;                           ///< CPU time
    Counters counters;
    Column t, error_at;  ///< the error over time
    Column x, v, exact;  ///< at the end

    report::Quantities measured() const;
};

/// Runs its periods by RK4, whose own error is far below. Throws Unstable, std::invalid_argument.
WaveRun run_wave(const WaveScene& scene, const GasMethod& method);

/// omega^2 of the wave as it runs, for comparison with dispersion(): c_s = 1 at the density that the lattice
/// has by summation, and h in spacings exact. The discrete wave is an eigenmode of even particles; its period
/// is taken over `periods` periods of leapfrog, whose known shift of frequency is taken out.
double measured_omega2(const WaveScene& scene, const GasMethod& method, int periods = 2);

/// The scene `wave` of the reader's own.
class WaveCommand {
  public:
    void declare(app::CommandLine& line);
    void run(report::Run& run) const;

  private:
    MethodChoice choice_;
    double gamma_ = 5.0 / 3;
    long particles_ = 100;
};

}  // namespace sph::euler
