#include "chapters/05_tensile_instability/scenes/elastic_grid.hpp"

#include <cmath>
#include <numbers>

#include "common/core/march.hpp"

namespace sph::tensile {

ElasticGrid::ElasticGrid(std::size_t columns, std::size_t rows, double dx, const Elastic& matter)
    : columns_{columns}, rows_{rows}, dx_{dx}, matter_{matter} {
    for (Column* one : {&xx_, &yy_, &xy_, &v[0], &v[1], &a_[0], &a_[1]}) one->assign(columns * rows, 0.0);
}

bool ElasticGrid::step(double& t, double dt) {
    kick(dt / 2);  // with the forces at the end of the last step
    strain(dt);
    accelerate();
    kick(dt / 2);
    t += dt;
    return true;
}

void ElasticGrid::kick(double dt) {
    for (std::size_t a = 0; a < 2; ++a)
        for (std::size_t i = 0; i < a_[a].size(); ++i) v[a][i] += dt * a_[a][i];
}

void ElasticGrid::accelerate() {
    const double factor = 1 / (matter_.rho0 * dx_);
    for (std::size_t i = 0; i < columns_; ++i) {
        const std::size_t here = i * rows_, left = (i > 0 ? i - 1 : columns_ - 1) * rows_,
                          right = (i + 1 < columns_ ? i + 1 : 0) * rows_;
        for (std::size_t j = 0; j < rows_; ++j) {
            const std::size_t below = j > 0 ? j - 1 : rows_ - 1, above = j + 1 < rows_ ? j + 1 : 0;
            a_[0][here + j] = factor * (xx_[here + j] - xx_[left + j] + xy_[here + above] - xy_[here + j]);
            a_[1][here + j] = factor * (xy_[right + j] - xy_[here + j] + yy_[here + j] - yy_[here + below]);
        }
    }
}

void ElasticGrid::strain(double dt) {
    const double lambda = dt / dx_ * matter_.lame(), mu = dt / dx_ * matter_.shear;
    for (std::size_t i = 0; i < columns_; ++i) {
        const std::size_t here = i * rows_, left = (i > 0 ? i - 1 : columns_ - 1) * rows_,
                          right = (i + 1 < columns_ ? i + 1 : 0) * rows_;
        for (std::size_t j = 0; j < rows_; ++j) {
            const std::size_t below = j > 0 ? j - 1 : rows_ - 1, above = j + 1 < rows_ ? j + 1 : 0;
            const double along = v[0][right + j] - v[0][here + j],
                         across = v[1][here + above] - v[1][here + j];
            xx_[here + j] += lambda * (along + across) + 2 * mu * along;
            yy_[here + j] += lambda * (along + across) + 2 * mu * across;
            xy_[here + j] += mu * (v[0][here + j] - v[0][here + below] + v[1][here + j] - v[1][left + j]);
        }
    }
}

report::Lap run_grid_elastic_wave(const ElasticWaveScene& scene) {
    ElasticGrid grid{scene.n, scene.rows, scene.spacing(), scene.matter()};
    const bool longitudinal = scene.longitudinal();
    Column& v = grid.v[longitudinal ? 0 : 1];
    Column start;
    for (std::size_t i = 0; i < v.size(); ++i) {
        const double place = static_cast<double>(i / scene.rows) + (longitudinal ? 0 : 0.5);
        start.push_back(scene.amplitude * std::sin(2 * std::numbers::pi * place * scene.spacing()));
    }
    v = start;
    report::Lap lap;
    double t = 0;
    const double period = 1 / scene.speed();
    const double dt = scene.courant * scene.spacing() / scene.matter().longitudinal_speed();
    const Marched done =
        march(grid, t, {.end = period, .steps = std::lround(std::ceil(period / dt))}, [&](double now) {
            lap.error = std::max(lap.error, standing_error(v, start, 2 * std::numbers::pi * now / period));
        });
    lap.seconds = done.seconds;
    return lap;
}

}  // namespace sph::tensile
