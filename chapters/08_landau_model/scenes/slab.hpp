#pragma once
#include <functional>
#include <string>
#include <vector>

#include "common/core/integrated.hpp"
#include "common/report/chapter.hpp"
#include "common/report/method.hpp"

/// Landau's slab: |x| <= 1 at rest at t = 0, s0 = eps0 = 1, P = eps/3, vacuum outside (Chen 2017, chapter 4).
namespace sph::landau {

/// What the scene gives to a method: the ends of the particles' cells.
struct SlabSetup {
    Column cells;
    double courant;
    int threads;
};
/// How the slab is resolved; h_over_dx counts in initial spacings, or in units of nu/s* where h varies.
struct SlabMethod : report::Method<Integrated<1>, SlabSetup> {
    bool graded = false;  ///< particles become lighter towards the edges
};
/// From the thesis' to the recommended one.
const report::Methods<SlabMethod>& slab_methods();

struct SlabScene {
    std::size_t n = 1000;       ///< particles in |x| <= 1
    std::vector<double> times;  ///< increasing, >= 0: when profiles are taken
    /// Step over the time in which sound crosses an h. The default keeps the energy to 1e-9; 0.5 gives the
    /// same profiles to 3 % of their error.
    double courant = default_courant;
    int threads = 1;
    std::function<void(double share)> progress{};
    static constexpr double default_courant = 0.08, fast_courant = 0.5;
};

struct SlabProfile {
    double time = 0;
    Column x, s_star, eps, rapidity;                 ///< of the particles, in order
    Column exact_s_star, exact_eps, exact_rapidity;  ///< at the same places
    /// Relative L1 over |x| <= 1 + t: particles joined by lines, 0 beyond the last one.
    double l1_s_star = 0;
    double energy_drift = 0, momentum = 0;  ///< relative to the energy at t = 0
    double edge_gap = 0;                    ///< from the last particle to the vacuum at 1 + t
    double seconds = 0;                     ///< CPU time of the steps until here
    Counters counters;
};

/// Runs RK4 and takes a profile at each time. Throws Unstable where the run leaves physics: particles that
/// overtake each other included.
/// Cost: four evaluations a step; steps ~ n/courant.
std::vector<SlabProfile> run_slab(const SlabScene& scene, const SlabMethod& method);

/// The relative L1 error of a profile at time t, as in SlabProfile, for values on increasing places x.
double slab_error(const Column& x, const Column& s_star, double t);

/// The ends of n cells in |x| <= 1: even, or those of x = sin(pi xi/2), whose widths shrink in proportion to
/// the square root of the distance to the edge.
Column slab_cells(std::size_t n, bool graded);

/// The scene `slab` of the reader's own.
class SlabCommand {
  public:
    SlabCommand();
    void declare(app::CommandLine& line);
    void run(report::Run& run) const;

  private:
    report::MethodOptions<SlabMethod> method_;
    double time_ = 10, courant_ = SlabScene::default_courant;
    long particles_ = 1000;
};

}  // namespace sph::landau
