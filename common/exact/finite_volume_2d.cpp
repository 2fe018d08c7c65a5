#include "common/exact/finite_volume_2d.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "common/exact/finite_volume_steps.hpp"
#include "common/exact/require.hpp"

namespace exact {

using steps::problem;

void GasGrid::fill(const std::function<GasState2D(double x, double y)>& state) {
    states.resize(nx * ny);
    for (std::size_t j = 0; j < ny; ++j) {
        for (std::size_t i = 0; i < nx; ++i) at(i, j) = state(x(i), y(j));
    }
}

FiniteVolume2D::Rows::Rows(std::size_t size)
    : west{size},
      east{size},
      south{size},
      north{Columns{size}, Columns{size}},
      flux_x{north},
      flux_y{north},
      rate_x{std::vector<double>(size), std::vector<double>(size)},
      rate_y{rate_x},
      shock_x{rate_x},
      shock_y{rate_x},
      rate(size),
      ones(size, 1) {}

FiniteVolume2D::FiniteVolume2D(const GasGrid& initial, const FiniteVolume2DOptions& options)
    : options_{options},
      grid_{initial},
      stride_{initial.nx + 2 * ghosts},
      gas_{stride_ * (initial.ny + 2 * ghosts)},
      next_gas_{gas_},
      order_(stride_ * (initial.ny + 2 * ghosts), 1),
      rows_{stride_} {
    check(initial);
    grid_.states.clear();
    for (std::size_t j = 0; j < grid_.ny; ++j) {
        for (std::size_t i = 0; i < grid_.nx; ++i) {
            const std::size_t k = index(i, j);
            const auto& [rho, vx, vy, p] = initial.at(i, j);
            gas_.rho[k] = rho, gas_.vx[k] = vx, gas_.vy[k] = vy, gas_.p[k] = p;
            gas_.energy[k] = p / (options_.gamma - 1) + rho * (vx * vx + vy * vy) / 2;
        }
    }
}

void FiniteVolume2D::check(const GasGrid& initial) const {
    const auto& o = options_;
    require(initial.nx >= 2, problem, "nx", static_cast<double>(initial.nx), "2 and above");
    require(initial.ny >= 2, problem, "ny", static_cast<double>(initial.ny), "2 and above");
    require(initial.states.size() == initial.nx * initial.ny, problem, "number of states",
            static_cast<double>(initial.states.size()), "nx ny");
    require(initial.x_begin < initial.x_end && std::isfinite(initial.dx()), problem, "x_end", initial.x_end,
            "x_begin < x_end");
    require(initial.y_begin < initial.y_end && std::isfinite(initial.dy()), problem, "y_end", initial.y_end,
            "y_begin < y_end");
    require(o.gamma > 1 && o.gamma <= 100, problem, "gamma", o.gamma, "(1, 100]");
    require(o.courant > 0 && o.courant <= 1, problem, "courant", o.courant, "(0, 1]");
    require(o.viscosity >= 0 && std::isfinite(o.viscosity), problem, "viscosity", o.viscosity, "0 and above");
    const auto periodic = [](End end) { return end == End::periodic; };
    require(periodic(o.left) == periodic(o.right) && periodic(o.bottom) == periodic(o.top), problem,
            "number of periodic ends", 1, "both of a direction or none");
    for (const End end : {o.left, o.right, o.bottom, o.top})
        require(end != End::inflow || o.inflow, problem, "inflow", 0, "a function where an end has inflow");
    for (const auto& [rho, vx, vy, p] : initial.states) {
        require(rho > 0 && std::isfinite(rho), problem, "rho", rho, "the finite numbers above 0");
        require(std::isfinite(vx), problem, "vx", vx, "the finite numbers");
        require(std::isfinite(vy), problem, "vy", vy, "the finite numbers");
        require(p > 0 && std::isfinite(p), problem, "p", p, "the finite numbers above 0");
    }
}

// Rows first, then columns with the ghosts of the rows, so that the corners are known, too.
void FiniteVolume2D::fill_ghosts(Gas& gas) const {
    // A line of n cells from `first` on, one every `stride`; `along` it and `across` it are the velocities.
    const auto fill = [&](std::size_t first, std::size_t n, std::size_t stride, End low, End high,
                          std::vector<double>& along, std::vector<double>& across) {
        const auto copy = [&](std::size_t ghost, std::size_t from, End end) {
            gas.rho[ghost] = gas.rho[from], gas.p[ghost] = gas.p[from];
            along[ghost] = end == End::reflecting ? -along[from] : along[from];
            across[ghost] = across[from];
        };
        const std::size_t last = first + (n - 1) * stride;
        for (std::size_t k = 0; k < ghosts; ++k) {
            const std::size_t from_first = first + k * stride, from_last = last - k * stride;
            const std::size_t below = first - (k + 1) * stride, above = last + (k + 1) * stride;
            if (low != End::inflow) copy(below, steps::shown(low, first, from_first, from_last), low);
            if (high != End::inflow) copy(above, steps::shown(high, last, from_last, from_first), high);
        }
    };
    for (std::size_t j = 0; j < grid_.ny; ++j)
        fill(index(0, j), grid_.nx, 1, options_.left, options_.right, gas.vx, gas.vy);
    for (std::size_t i = 0; i < stride_; ++i)
        fill(ghosts * stride_ + i, grid_.ny, stride_, options_.bottom, options_.top, gas.vy, gas.vx);
    fill_inflow(gas);
}

void FiniteVolume2D::fill_inflow(Gas& gas) const {
    const auto set = [&](std::size_t i, std::size_t j) {  // counted with the ghosts
        const double x = grid_.x_begin + (static_cast<double>(i) - ghosts + 0.5) * grid_.dx();
        const double y = grid_.y_begin + (static_cast<double>(j) - ghosts + 0.5) * grid_.dy();
        const auto [rho, vx, vy, p] = options_.inflow(x, y, time_);
        const std::size_t k = j * stride_ + i;
        gas.rho[k] = rho, gas.vx[k] = vx, gas.vy[k] = vy, gas.p[k] = p;
    };
    for (std::size_t k = 0; k < ghosts; ++k) {
        for (std::size_t j = 0; j < grid_.ny + 2 * ghosts; ++j) {
            if (options_.left == End::inflow) set(k, j);
            if (options_.right == End::inflow) set(ghosts + grid_.nx + k, j);
        }
        for (std::size_t i = 0; i < stride_; ++i) {
            if (options_.bottom == End::inflow) set(i, k);
            if (options_.top == End::inflow) set(i, ghosts + grid_.ny + k);
        }
    }
}

void FiniteVolume2D::advance_to(double t) {
    require(t >= time_ && std::isfinite(t), problem, "time", t, "the present one and later, finite");
    while (time_ < t) {
        fill_ghosts(gas_);
        if (rate_ == 0) attempt(0);
        step(t);
    }
    apply_viscosity(time_ - viscous_time_);
}

void FiniteVolume2D::step(double end) {
    const double fastest = std::max(rate_, viscous_rate());
    double dt = options_.courant * (steps_ < steps::slow_steps ? steps::slow_start : 1) / fastest;
    for (int repeats = 0; repeats <= steps::most_repeats; ++repeats) {
        const bool last = !(dt < end - time_);
        if (last) dt = end - time_;
        if (!(time_ + dt > time_)) break;
        apply_viscosity(time_ + dt / 2 - viscous_time_);
        const bool positive = attempt(dt);
        if (positive && dt * rate_ <= 1) {
            std::swap(gas_, next_gas_);
            time_ = last ? end : time_ + dt;
            ++steps_;
            if (std::exchange(lowered_, false)) std::fill(order_.begin(), order_.end(), 1);
            return;
        }
        ++repeated_;
        // A wave became faster than in the step before, or slopes go first and then length.
        dt = std::min(options_.courant / rate_, !positive && lowered_ ? dt / 2 : dt);
        if (!positive) lower_order();
    }
    give_up();
}

// The failed cells and their neighbours.
void FiniteVolume2D::lower_order() {
    lowered_ = true;
    for (std::size_t j = 0; j < grid_.ny; ++j) {
        for (std::size_t i = 0; i < grid_.nx; ++i) {
            const std::size_t k = index(i, j);
            if (next_gas_.rho[k] > 0 && next_gas_.p[k] > 0) continue;
            for (std::size_t row = j; row <= j + 2; ++row) {
                const auto first = order_.begin() + static_cast<std::ptrdiff_t>((row + 1) * stride_ + i + 1);
                std::fill(first, first + 3, 0);
            }
        }
    }
}

void FiniteVolume2D::give_up() const {
    std::ostringstream text;
    text << "time " << time_ << ": ";
    for (std::size_t j = 0; j < grid_.ny; ++j) {
        for (std::size_t i = 0; i < grid_.nx; ++i) {
            const double rho = next_gas_.rho[index(i, j)], p = next_gas_.p[index(i, j)];
            if (rho > 0 && p > 0) continue;
            text << "cell (" << i << ", " << j << ") at (" << grid_.x(i) << ", " << grid_.y(j)
                 << "): density " << rho << ", pressure " << p;
            throw UnphysicalCell{text.str()};
        }
    }
    // All are positive, but waves cross one faster than any step that still moves the clock.
    text << "waves cross a cell at the rate " << rate_;
    throw UnphysicalCell{text.str()};
}

GasGrid FiniteVolume2D::cells() const {
    GasGrid cells = grid_;
    cells.states.resize(grid_.nx * grid_.ny);
    for (std::size_t j = 0; j < grid_.ny; ++j) {
        for (std::size_t i = 0; i < grid_.nx; ++i) {
            const std::size_t k = index(i, j);
            cells.at(i, j) = {gas_.rho[k], gas_.vx[k], gas_.vy[k], gas_.p[k]};
        }
    }
    return cells;
}

FiniteVolume2D::Totals FiniteVolume2D::totals() const {
    long double mass = 0, x = 0, y = 0, energy = 0;
    for (std::size_t j = 0; j < grid_.ny; ++j) {
        for (std::size_t i = 0; i < grid_.nx; ++i) {
            const std::size_t k = index(i, j);
            mass += gas_.rho[k], energy += gas_.energy[k];
            x += gas_.rho[k] * gas_.vx[k], y += gas_.rho[k] * gas_.vy[k];
        }
    }
    const auto whole = [&](long double sum) { return static_cast<double>(sum) * grid_.dx() * grid_.dy(); };
    return {whole(mass), whole(x), whole(y), whole(energy)};
}

long FiniteVolume2D::cell_updates() const noexcept {
    return static_cast<long>(grid_.nx * grid_.ny) * (steps_ + repeated_);
}

}  // namespace exact
