#pragma once
#include "chapters/05_tensile_instability/scenes/solid.hpp"

/// A disc whose particles lie irregularly, thrown outwards: does it stay whole? Radius 1, K = rho = 1; v =
/// v_0 x at first, so that it stretches evenly, and springs back.
namespace sph::tensile {

struct ElasticDiscScene {
    std::size_t n = 500;
    double shear = 0.22;  ///< mu [K]
    double speed = 0.35;  ///< v_0, of the rim [sqrt(K/rho)]
    double time = 40;     ///< [R/sqrt(K/rho)]
    double courant = 0.5;
    int threads = 1;
};
struct ElasticDiscRun {
    Pieces pieces;              ///< at the end
    double largest_share = 0;   ///< of the particles, in the largest piece
    double energy_left = 0;     ///< at the end, over the beginning
    double momentum_drift = 0;  ///< over M v_0
    double reached = 0;         ///< time of the end: earlier where it became unphysical
    Columns<2> x;
    Column radius;  ///< of each particle at the beginning
    long steps = 0;
    report::Quantities measured() const;
};
/// A run that becomes unphysical ends there. Where particles lie irregularly, the total Lagrangian method
/// takes h = dx.
ElasticDiscRun run_elastic_disc(const ElasticDiscScene& scene, const SolidMethod& method);

/// n points in the unit circle, relaxed: they begin on Vogel's spiral and repel each other until they are
/// even.
Columns<2> relaxed_disc(std::size_t n, int threads);

/// The scene `elastic-disc` of the reader's own.
class ElasticDiscCommand {
  public:
    void declare(app::CommandLine& line);
    void run(report::Run& run) const;

  private:
    std::string method_ = "total-lagrangian";
    long particles_ = 500;
    double shear_ = 0.22, speed_ = 0.35, time_ = 40;
};

}  // namespace sph::tensile
