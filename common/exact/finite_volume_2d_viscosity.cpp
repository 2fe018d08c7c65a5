// The viscous part of a step, which does nothing without viscosity.
#include "common/exact/finite_volume_2d.hpp"

namespace exact {
namespace {

/// Momentum and energy that leave through a face per area and time: minus the stress, and minus its work.
struct Viscous {
    double x, y, energy;
};

/// Stress on the face between two cells. `d_n`, `d_t`: derivatives of the normal and the tangential velocity
/// along the normal; `t_n`, `t_t`: along the face. Returns normal and tangential components as x and y.
Viscous face(double mu, double d_n, double d_t, double t_n, double t_t, double n, double t) {
    const double normal = mu * (2 * d_n - 2.0 / 3 * (d_n + t_t)), tangential = mu * (d_t + t_n);
    return {-normal, -tangential, -normal * n - tangential * t};
}

}  // namespace

/// Largest eigenvalue of the viscous operator over two, Heun's limit: nu 8/3 (1/dx^2 + 1/dy^2) or less.
double FiniteVolume2D::viscous_rate() const {
    return options_.viscosity * 8 / 3 * (1 / (grid_.dx() * grid_.dx()) + 1 / (grid_.dy() * grid_.dy()));
}

/// Euler's step, to = from + dt d/dt from, in momentum and energy (the density stays); or the second of
/// Heun's, to = (to + from + dt d/dt from)/2.
template <bool euler>
void FiniteVolume2D::viscous_stage(const Gas& from, Gas& to, double dt) const {
    const double nu = options_.viscosity, gamma_1 = options_.gamma - 1;
    const double per_dx = 1 / grid_.dx(), per_dy = 1 / grid_.dy();
    const std::size_t up = stride_;
    const double *rho = from.rho.data(), *vx = from.vx.data(), *vy = from.vy.data(),
                 *energy = from.energy.data();
    const auto face_x = [=](std::size_t k) {  // between cells k and k + 1
        const std::size_t r = k + 1;
        return face(nu * (rho[k] + rho[r]) / 2, (vx[r] - vx[k]) * per_dx, (vy[r] - vy[k]) * per_dx,
                    (vx[k + up] + vx[r + up] - vx[k - up] - vx[r - up]) * per_dy / 4,
                    (vy[k + up] + vy[r + up] - vy[k - up] - vy[r - up]) * per_dy / 4, (vx[k] + vx[r]) / 2,
                    (vy[k] + vy[r]) / 2);
    };
    const auto face_y = [=](std::size_t k) {  // between cell k and the one above
        const std::size_t r = k + up;
        return face(nu * (rho[k] + rho[r]) / 2, (vy[r] - vy[k]) * per_dy, (vx[r] - vx[k]) * per_dy,
                    (vy[k + 1] + vy[r + 1] - vy[k - 1] - vy[r - 1]) * per_dx / 4,
                    (vx[k + 1] + vx[r + 1] - vx[k - 1] - vx[r - 1]) * per_dx / 4, (vy[k] + vy[r]) / 2,
                    (vx[k] + vx[r]) / 2);
    };
    double *to_rho = to.rho.data(), *to_vx = to.vx.data(), *to_vy = to.vy.data(), *to_p = to.p.data(),
           *to_e = to.energy.data();
    const double x = dt * per_dx, y = dt * per_dy;
    for (std::size_t j = 0; j < grid_.ny; ++j) {
        const std::size_t begin = index(0, j), end = begin + grid_.nx;
#pragma GCC ivdep
        for (std::size_t k = begin; k < end; ++k) {
            const Viscous w = face_x(k - 1), e = face_x(k), s = face_y(k - up), n = face_y(k);
            const double volume = 1 / rho[k];
            const double e_new = energy[k] - x * (e.energy - w.energy) - y * (n.energy - s.energy);
            const double v = vx[k] - volume * (x * (e.x - w.x) + y * (n.y - s.y));
            const double t = vy[k] - volume * (x * (e.y - w.y) + y * (n.x - s.x));
            const double new_vx = euler ? v : (to_vx[k] + v) / 2, new_vy = euler ? t : (to_vy[k] + t) / 2;
            const double new_energy = euler ? e_new : (to_e[k] + e_new) / 2;
            to_rho[k] = rho[k], to_vx[k] = new_vx, to_vy[k] = new_vy, to_e[k] = new_energy;
            to_p[k] = gamma_1 * (new_energy - rho[k] * (new_vx * new_vx + new_vy * new_vy) / 2);
        }
    }
}

void FiniteVolume2D::apply_viscosity(double dt) {
    if (!(options_.viscosity > 0 && dt > 0)) return;
    viscous_time_ += dt;
    fill_ghosts(gas_);
    viscous_stage<true>(gas_, next_gas_, dt);
    fill_ghosts(next_gas_);
    viscous_stage<false>(next_gas_, gas_, dt);
    fill_ghosts(gas_);
}

}  // namespace exact
