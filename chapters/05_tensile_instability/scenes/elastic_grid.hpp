#pragma once
#include <array>
#include <cstddef>

#include "chapters/05_tensile_instability/scenes/elastic_wave.hpp"
#include "common/core/stepper.hpp"
#include "common/report/race.hpp"

namespace sph::tensile {

/// The competitor: rho dv/dt = div sigma and dsigma/dt = lambda tr(grad v) + mu (grad v + grad v^T) in plane
/// strain, by central differences on a staggered, periodic grid (Virieux 1986). sigma_xx and sigma_yy stand
/// in the middles of cells, v on the faces that it crosses, sigma_xy on the corners, so each slope is one
/// difference over dx. Small strains only; no neighbours to find.
class ElasticGrid : public Stepper {
  public:
    /// columns x rows cells of width dx > 0, at rest and without stress.
    ElasticGrid(std::size_t columns, std::size_t rows, double dx, const Elastic& matter);

    /// v_x at (i dx, (j + 1/2) dx), v_y at ((i + 1/2) dx, j dx), both in place i rows + j.
    std::array<Column, 2> v;
    /// One step of kick-drift-kick; stable for dt <= dx/(c_l sqrt 2).
    bool step(double& t, double dt) override;

  private:
    void accelerate();
    void strain(double dt);
    void kick(double dt);

    std::size_t columns_, rows_;
    double dx_;
    Elastic matter_;
    Column xx_, yy_, xy_;
    std::array<Column, 2> a_;
};

/// The wave of run_elastic_wave on a grid of as many cells as it has particles: the same error, CPU seconds.
report::Lap run_grid_elastic_wave(const ElasticWaveScene& scene);

}  // namespace sph::tensile
