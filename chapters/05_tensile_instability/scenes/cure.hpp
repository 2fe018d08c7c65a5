#pragma once
#include "chapters/05_tensile_instability/scenes/cure_methods.hpp"
#include "common/report/chapter.hpp"

/// What a cure is worth: disordered particles under tension, left alone.
namespace sph::tensile {

struct CureScene {
    std::size_t n = 20;  ///< particles along each side
    double pressure = -0.2, jitter = 0.1, time = 100, courant = 0.25;
    double shear = 0;   ///< v_x = shear sin(2 pi y/side) at the start   [c]
    bool drop = false;  ///< in free space
    std::uint64_t seed = 1;
    int threads = 1;
    std::function<void(double)> progress{};
};

/// What a run leaves. Lengths in dx, speeds in c.
struct CureRun {
    Columns<2> x, v;  ///< at the end, inside the box
    double smallest_distance = 0;
    double order = 0;           ///< 1 on a square or hexagonal lattice, 0.5 without order
    double momentum_drift = 0;  ///< largest |sum m v| of a component, a particle   [c]
    double energy_drift = 0;    ///< largest change of the energy, a particle   [c^2]
    double kept_shear = 0;      ///< of the amplitude at the start
    double radius = 1;          ///< root mean square distance from the middle, over that at the start
    double pairs = 0, seconds = 0;
    long evaluations = 0;  ///< of the rates

    double nanoseconds() const;  ///< CPU time of an evaluation of the rates, a particle
    report::Quantities measured() const;
    report::Quantities costs() const;
};

/// Throws Unstable where the run leaves physics.
CureRun run_cure(const CureScene& scene, const CureMethod& method);

/// Mean over particles of |1/k sum exp(i k angle)| over their k nearest neighbours, the larger one of k = 4
/// and k = 6; `box` periodic, at least 7 particles.
double bond_order(const Columns<2>& x, const Box<2>& box);

/// growth, sound_speed, shear_speed of the lattice.
report::Quantities lattice_merits(const CureMethod& method, double pressure);

/// The scene `cure` of the reader's own.
class CureCommand {
  public:
    CureCommand();
    void declare(app::CommandLine& line);
    void run(report::Run& run) const;

  private:
    report::MethodOptions<CureMethod> method_;
    double pressure_ = -0.2, jitter_ = 0.1, time_ = 100;
    long particles_ = 20;
};

}  // namespace sph::tensile
