#pragma once
#include "chapters/04_artificial_viscosity/scenes/methods.hpp"
#include "common/report/chapter.hpp"

/// Sedov's blast on a line, in the plane and in space: the energy 1 at the origin of a cold gas of density 1,
/// spread over a kernel; the part with all coordinates positive, between mirrors.
namespace sph::godunov {

struct BlastScene {
    double gamma = 5.0 / 3;
    double radius = 0.4;     ///< of the exact shock at the end; faces are at 0.5
    double pressure = 1e-6;  ///< of the cold gas; the exact solution has 0
    double blast_width = 4;  ///< smoothing length of the cubic spline that spreads the energy, in spacings
    std::size_t n = 16;      ///< spacings in the side 0.5
    double courant = 0.3;
    long most_steps = 4000;  ///< more, and the run stops: steps that collapse would never end
    int threads = 1;
};

template <int d>
struct BlastRun {
    Columns<d> x;                           ///< at the end
    Column r, m, rho, v_r, p;               ///< of the particles
    double time = 0;                        ///< of the end
    double l1_rho = 0, l1_v = 0, l1_p = 0;  ///< relative, by volume, over r < 0.45
    double peak = 0;                        ///< the largest mean density of a shell, over the exact one
    double shock = 0;         ///< where the mean density of shells falls through 1 + half its peak's excess
    double energy_drift = 0;  ///< relative
    Counters counters;
    double seconds = 0;  ///< CPU time of the steps

    report::Quantities measured() const;
};
/// d = 1, 2, 3. Throws Unstable where the run leaves physics.
template <int d>
BlastRun<d> run_blast(const BlastScene& scene, const shocks::Method<d>& method);

/// The scene `sedov` of the reader's own. Leaves rows of results.csv, profile.csv (r,rho,v,p of the
/// particles) and the figure "sedov".
class SedovInSpace {
  public:
    void declare(app::CommandLine& line);
    void run(report::Run& run) const;

  private:
    template <int d>
    void run_in(report::Run& run, const shocks::Methods<d>& methods) const;

    long dimension_ = 3, particles_ = 16;
    double gamma_ = 5.0 / 3;
    std::string method_ = "godunov";
};

}  // namespace sph::godunov
