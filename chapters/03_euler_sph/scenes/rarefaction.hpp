#pragma once
#include "chapters/03_euler_sph/scenes/methods.hpp"
#include "common/report/chapter.hpp"

/// Gas at rest in |x| <= 0.5 that expands into the vacuum (Monaghan 2005, section 9, figure 14): rho = 1,
/// u = 2, gamma = 1.4. Each particle carries its thermal energy.
namespace sph::euler {

struct RarefactionScene {
    std::size_t n = 200;
    double gamma = 1.4, u = 2;  ///< adiabatic index; thermal energy by mass at t = 0
    double time = 0.4;          ///< less than that at which the two rarefactions meet
    bool graded = false;        ///< spacing and mass five times less at the edges; even as in figure 14
    double courant = 0.3;       ///< time step [least spacing/c_s]
    int threads = 1;
    std::function<void(double)> progress{};
};

struct RarefactionRun {
    double velocity_error = 0, density_error = 0;  ///< relative L1 over the particles, by their spacings
    double energy_drift = 0, momentum = 0;         ///< relative to the energy; by mass and sound speed
    double edge = 0, front = 0;                    ///< where the last particle is, and the exact gas ends
    Counters counters;
    Column x, v, rho, exact_v, exact_rho;

    report::Quantities measured() const;
};

/// Throws Unstable when the gas has come apart.
RarefactionRun run_rarefaction(const RarefactionScene& scene, const GasMethod& method);

/// The scene `rarefaction` of the reader's own.
class RarefactionCommand {
  public:
    void declare(app::CommandLine& line);
    void run(report::Run& run) const;

  private:
    MethodChoice choice_;
    std::string spacing_ = "graded";
    double gamma_ = 5.0 / 3;
    long particles_ = 100;
};

}  // namespace sph::euler
