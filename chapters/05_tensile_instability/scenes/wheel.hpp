#pragma once
#include <limits>

#include "chapters/05_tensile_instability/scenes/solid.hpp"

/// An elastic wheel that turns freely (Monaghan 2005, section 11: "a spectacular example"): a disc of radius
/// 1 with K = rho = 1, rotating like a rigid body at first. Nothing acts on it, so its angular momentum
/// stays.
namespace sph::tensile {

struct WheelScene {
    std::size_t across = 16;  ///< particles across the wheel; >= 8
    double shear = 0.22;      ///< mu [K]
    double rim = 0.1;         ///< speed of the rim [c_l]; below 0.5
    double turns = 10;
    double courant = 0.5;
    int threads = 1;
};
struct WheelRun {
    std::size_t n = 0;
    double loss = 0;                       ///< largest |L/L_0 - 1|
    double after_one = 0, after_half = 0;  ///< L/L_0 - 1 after one turn, and after half of one
    double turns = 0;                      ///< that the run came to: fewer where it became unphysical
    double energy_drift = 0;               ///< largest, over the beginning
    double momentum_drift = 0;             ///< over M times the speed of the rim
    Column t, change;                      ///< turns, L/L_0 - 1
    Columns<2> x;                          ///< at the end
    Column angle;                          ///< of each particle at the beginning
    report::Quantities measured() const;
};
/// A run that becomes unphysical ends there, and says so by `turns`.
WheelRun run_wheel(const WheelScene& scene, const SolidMethod& method);

/// The scene `wheel` of the reader's own.
class WheelCommand {
  public:
    void declare(app::CommandLine& line);
    void run(report::Run& run) const;

  private:
    std::string method_ = "total-lagrangian";
    long across_ = 16;
    double shear_ = 0.22, rim_ = 0.1, turns_ = 10;
};

}  // namespace sph::tensile
