// The loops of a step, row by row so that what a row leaves for the next stays in the cache. All are
// vectorised: `ivdep` tells the compiler that the columns do not overlap.
#include <cmath>

#include "common/exact/finite_volume_2d.hpp"
#include "common/exact/finite_volume_steps.hpp"
#include "common/exact/hllc.hpp"

namespace exact {
namespace {

/// A shock whose pressures differ by more than this times the lower one is a strong one. The carbuncle is
/// known from Mach 2 (4.5) on.
constexpr double strong = 2;

double limited(double before, double here, double after) {
    return hllc::limited(here - before, after - here, 0.5, 0.5);
}

/// A row of states beside faces, and of fluxes: normal and tangential velocity or momentum.
struct States {
    const double *rho, *n, *t, *p;
};
struct Fluxes {
    double *mass, *n, *t, *energy;
};

/// The fluxes through `count` faces between the states l[i] and r[i], and the speed of the fastest wave of
/// each. With shocks: by HLL where either mark is set.
template <bool shocks>
void solve(const States& l, const States& r, const double* mark_l, const double* mark_r, const Fluxes& flux,
           double* speed, std::size_t count, double gamma) {
    const double *l_rho = l.rho, *l_n = l.n, *l_t = l.t, *l_p = l.p;
    const double *r_rho = r.rho, *r_n = r.n, *r_t = r.t, *r_p = r.p;
    double *f_mass = flux.mass, *f_n = flux.n, *f_t = flux.t, *f_energy = flux.energy;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        const hllc::Gas left{l_rho[i], l_n[i], l_p[i]}, right{r_rho[i], r_n[i], r_p[i]};
        const hllc::Fan waves = hllc::fan(left, right, gamma);
        hllc::Flux f = hllc::flux(left, right, waves, gamma);
        double t = waves.contact > 0 ? l_t[i] : r_t[i];
        double momentum_t = f.mass * t, energy_t = momentum_t * t / 2;
        if constexpr (shocks) {
            const bool marked = mark_l[i] + mark_r[i] > 0;
            const hllc::HllWeights weight = hllc::hll_weights(waves);
            const hllc::Flux g = hllc::hll(left, right, weight, gamma);
            const double mass_l = (weight.l * left.v - weight.j) * left.rho;
            const double mass_r = (weight.r * right.v + weight.j) * right.rho;
            f.mass = marked ? g.mass : f.mass;
            f.momentum = marked ? g.momentum : f.momentum;
            f.energy = marked ? g.energy : f.energy;
            momentum_t = marked ? mass_l * l_t[i] + mass_r * r_t[i] : momentum_t;
            energy_t = marked ? (mass_l * l_t[i] * l_t[i] + mass_r * r_t[i] * r_t[i]) / 2 : energy_t;
        }
        f_mass[i] = f.mass, f_n[i] = f.momentum, f_t[i] = momentum_t, f_energy[i] = f.energy + energy_t;
        speed[i] = hllc::larger(waves.right, -waves.left);
    }
}

}  // namespace

bool FiniteVolume2D::attempt(double dt) {
    rate_ = 0;
    bool positive = true;
    // Rows counted with one ghost before and after: row j leaves its faces to row j - 1.
    for (std::size_t j = 0; j < grid_.ny + 2; ++j) {
        predict(j, dt);
        solve_faces(j);
        if (j >= 2) positive &= update(j, dt);
    }
    return positive;
}

/// gas -> west, east, south, north of row j - 1.
void FiniteVolume2D::predict(std::size_t j, double dt) {
    const std::size_t first = (j + 1) * stride_;
    const double *rho = gas_.rho.data() + first, *vx = gas_.vx.data() + first, *vy = gas_.vy.data() + first,
                 *p = gas_.p.data() + first;
    const double* order = lowered_ ? order_.data() + first : rows_.ones.data();
    Columns &w = rows_.west, &e = rows_.east, &s = rows_.south, &n = rows_.north[j % 2];
    double *w_rho = w.rho.data(), *w_n = w.n.data(), *w_t = w.t.data(), *w_p = w.p.data();
    double *e_rho = e.rho.data(), *e_n = e.n.data(), *e_t = e.t.data(), *e_p = e.p.data();
    double *s_rho = s.rho.data(), *s_n = s.n.data(), *s_t = s.t.data(), *s_p = s.p.data();
    double *n_rho = n.rho.data(), *n_n = n.n.data(), *n_t = n.t.data(), *n_p = n.p.data();
    double *shock_x = rows_.shock_x[j % 2].data(), *shock_y = rows_.shock_y[j % 2].data();
    const double half_x = dt / 2 / grid_.dx(), half_y = dt / 2 / grid_.dy(), gamma = options_.gamma;
    const auto up = static_cast<std::ptrdiff_t>(stride_);
#pragma GCC ivdep
    for (std::ptrdiff_t i = 1; i < up - 1; ++i) {
        const double ax = order[i] * limited(rho[i - 1], rho[i], rho[i + 1]);
        const double bx = order[i] * limited(vx[i - 1], vx[i], vx[i + 1]);
        const double cx = order[i] * limited(vy[i - 1], vy[i], vy[i + 1]);
        const double dx = order[i] * limited(p[i - 1], p[i], p[i + 1]);
        const double ay = order[i] * limited(rho[i - up], rho[i], rho[i + up]);
        const double by = order[i] * limited(vx[i - up], vx[i], vx[i + up]);
        const double cy = order[i] * limited(vy[i - up], vy[i], vy[i + up]);
        const double dy = order[i] * limited(p[i - up], p[i], p[i + up]);
        const double volume = 1 / rho[i];
        double a = rho[i] - half_x * (vx[i] * ax + rho[i] * bx) - half_y * (vy[i] * ay + rho[i] * cy);
        double b = vx[i] - half_x * (vx[i] * bx + volume * dx) - half_y * vy[i] * by;
        double c = vy[i] - half_x * vx[i] * cx - half_y * (vy[i] * cy + volume * dy);
        double d =
            p[i] - half_x * (vx[i] * dx + gamma * p[i] * bx) - half_y * (vy[i] * dy + gamma * p[i] * cy);
        const double lowest_a = a - hllc::larger(std::abs(ax), std::abs(ay)) / 2;
        const double lowest_d = d - hllc::larger(std::abs(dx), std::abs(dy)) / 2;
        const double keep =
            hllc::both(lowest_a > steps::least * rho[i], lowest_d > steps::least * p[i]) ? 0.5 : 0;
        a = keep > 0 ? a : rho[i], b = keep > 0 ? b : vx[i], c = keep > 0 ? c : vy[i],
        d = keep > 0 ? d : p[i];
        w_rho[i] = a - keep * ax, w_n[i] = b - keep * bx, w_t[i] = c - keep * cx, w_p[i] = d - keep * dx;
        e_rho[i] = a + keep * ax, e_n[i] = b + keep * bx, e_t[i] = c + keep * cx, e_p[i] = d + keep * dx;
        s_rho[i] = a - keep * ay, s_n[i] = c - keep * cy, s_t[i] = b - keep * by, s_p[i] = d - keep * dy;
        n_rho[i] = a + keep * ay, n_n[i] = c + keep * cy, n_t[i] = b + keep * by, n_p[i] = d + keep * dy;
        const double step_x = std::abs(p[i + 1] - p[i - 1]), low_x = hllc::smaller(p[i + 1], p[i - 1]);
        const double step_y = std::abs(p[i + up] - p[i - up]), low_y = hllc::smaller(p[i + up], p[i - up]);
        shock_x[i] = hllc::both(step_x > strong * low_x, vx[i - 1] > vx[i + 1]) ? 1 : 0;
        shock_y[i] = hllc::both(step_y > strong * low_y, vy[i - up] > vy[i + up]) ? 1 : 0;
    }
}

/// west, east -> flux_x of row j - 1; north of row j - 2 and south of row j - 1 -> flux_y between them.
void FiniteVolume2D::solve_faces(std::size_t j) {
    const auto states = [](const Columns& c, std::size_t from) {
        return States{&c.rho[from], &c.n[from], &c.t[from], &c.p[from]};
    };
    const auto fluxes = [](Columns& c) {
        return Fluxes{&c.rho[ghosts], &c.n[ghosts], &c.t[ghosts], &c.p[ghosts]};
    };
    const std::size_t now = j % 2, last = 1 - now, first = ghosts;
    const auto any = [&](const std::vector<double>& marks) {
        return hllc::largest(marks.data(), stride_) > 0;
    };
    const auto &shock_x = rows_.shock_x, &shock_y = rows_.shock_y;
    if (j >= 1 && j <= grid_.ny) {
        const auto solve_x = any(shock_y[now]) ? solve<true> : solve<false>;
        solve_x(states(rows_.east, first - 1), states(rows_.west, first), &shock_y[now][first - 1],
                &shock_y[now][first], fluxes(rows_.flux_x[now]), &rows_.rate_x[now][first], grid_.nx + 1,
                options_.gamma);
    }
    if (j >= 1) {
        const auto solve_y = any(shock_x[now]) || any(shock_x[last]) ? solve<true> : solve<false>;
        solve_y(states(rows_.north[last], first), states(rows_.south, first), &shock_x[last][first],
                &shock_x[now][first], fluxes(rows_.flux_y[now]), &rows_.rate_y[now][first], grid_.nx,
                options_.gamma);
    }
}

/// gas, flux -> next_gas and rate of row j - 2, which lies between the last two rows of flux_y.
bool FiniteVolume2D::update(std::size_t j, double dt) {
    const std::size_t first = j * stride_, above = j % 2, here = 1 - above;
    const double *rho = gas_.rho.data() + first, *vx = gas_.vx.data() + first, *vy = gas_.vy.data() + first,
                 *energy = gas_.energy.data() + first;
    const Columns &fx = rows_.flux_x[here], &fs = rows_.flux_y[here], &fn = rows_.flux_y[above];
    const double *x_mass = fx.rho.data(), *x_n = fx.n.data(), *x_t = fx.t.data(), *x_e = fx.p.data();
    const double *s_mass = fs.rho.data(), *s_n = fs.n.data(), *s_t = fs.t.data(), *s_e = fs.p.data();
    const double *n_mass = fn.rho.data(), *n_n = fn.n.data(), *n_t = fn.t.data(), *n_e = fn.p.data();
    const double *speed_x = rows_.rate_x[here].data(), *speed_s = rows_.rate_y[here].data(),
                 *speed_n = rows_.rate_y[above].data();
    double *to_rho = next_gas_.rho.data() + first, *to_vx = next_gas_.vx.data() + first,
           *to_vy = next_gas_.vy.data() + first, *to_p = next_gas_.p.data() + first,
           *to_e = next_gas_.energy.data() + first, *rate = rows_.rate.data();
    const double per_dx = 1 / grid_.dx(), per_dy = 1 / grid_.dy(), gamma_1 = options_.gamma - 1;
    const double x = dt * per_dx, y = dt * per_dy;
#pragma GCC ivdep
    for (std::size_t i = ghosts; i < ghosts + grid_.nx; ++i) {
        const double new_rho = rho[i] - x * (x_mass[i + 1] - x_mass[i]) - y * (n_mass[i] - s_mass[i]);
        const double mx = rho[i] * vx[i] - x * (x_n[i + 1] - x_n[i]) - y * (n_t[i] - s_t[i]);
        const double my = rho[i] * vy[i] - x * (x_t[i + 1] - x_t[i]) - y * (n_n[i] - s_n[i]);
        const double e = energy[i] - x * (x_e[i + 1] - x_e[i]) - y * (n_e[i] - s_e[i]);
        const double new_vx = mx / new_rho, new_vy = my / new_rho;
        to_rho[i] = new_rho, to_vx[i] = new_vx, to_vy[i] = new_vy, to_e[i] = e;
        to_p[i] = gamma_1 * (e - (mx * new_vx + my * new_vy) / 2);
        rate[i] =
            per_dx * hllc::larger(speed_x[i], speed_x[i + 1]) + per_dy * hllc::larger(speed_s[i], speed_n[i]);
    }
    rate_ = hllc::larger(rate_, hllc::largest(rate + ghosts, grid_.nx));
    return hllc::all_positive(to_rho + ghosts, grid_.nx) && hllc::all_positive(to_p + ghosts, grid_.nx);
}

}  // namespace exact
