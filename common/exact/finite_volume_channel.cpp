#include "common/exact/finite_volume_channel.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "common/exact/finite_volume_steps.hpp"
#include "common/exact/hllc.hpp"
#include "common/exact/require.hpp"

namespace exact {
namespace {

constexpr const char* problem = steps::problem;

/// base + share * slope, or the base where that leaves too little of density or pressure.
GasState2D moved(const GasState2D& base, const GasState2D& slope, double share) {
    const GasState2D to{base.rho + share * slope.rho, base.vx + share * slope.vx, base.vy + share * slope.vy,
                        base.p + share * slope.p};
    return to.rho > steps::least * base.rho && to.p > steps::least * base.p ? to : base;
}
GasState2D slope_between(const GasState2D& before, const GasState2D& at, const GasState2D& after) {
    const auto limited = [](double a, double b, double c) { return hllc::limited(b - a, c - b, 0.5, 0.5); };
    return {limited(before.rho, at.rho, after.rho), limited(before.vx, at.vx, after.vx),
            limited(before.vy, at.vy, after.vy), limited(before.p, at.p, after.p)};
}

}  // namespace

FiniteVolumeChannel::FiniteVolumeChannel(const ChannelShape& shape, const GasState2D& entering, double gamma,
                                         double courant)
    : shape_{shape}, entering_{entering}, gamma_{gamma}, courant_{courant}, stride_{shape.nx + 2 * ghosts} {
    require(shape.nx >= 2, problem, "nx", static_cast<double>(shape.nx), "2 and above");
    require(shape.ny >= 2, problem, "ny", static_cast<double>(shape.ny), "2 and above");
    require(entering.rho > 0, problem, "rho", entering.rho, "the finite numbers above 0");
    require(entering.p > 0, problem, "p", entering.p, "the finite numbers above 0");
    require(gamma > 1 && gamma <= 100, problem, "gamma", gamma, "(1, 100]");
    require(courant > 0 && courant <= 1, problem, "courant", courant, "(0, 1]");
    gas_.assign(stride_ * (shape.ny + 2 * ghosts), entering);
    slope_x_ = slope_y_ = gas_;
    rate_.resize(gas_.size());
    flux_x_.resize(gas_.size()), flux_y_.resize(gas_.size()), before_.resize(gas_.size());
    measure_cells();
}

FiniteVolumeChannel::FiniteVolumeChannel(const ChannelShape& shape, const FiniteVolumeChannel& coarser)
    : FiniteVolumeChannel{shape, coarser.entering_, coarser.gamma_, coarser.courant_} {
    time_ = coarser.time_;
    for (std::size_t j = 0; j < shape.ny; ++j) {
        for (std::size_t i = 0; i < shape.nx; ++i) gas_[index(i, j)] = coarser.at_point(x(i), y(i, j));
    }
}

void FiniteVolumeChannel::measure_cells() {
    area_.resize(gas_.size());
    face_x_.resize(gas_.size()), face_y_.resize(gas_.size());
    const double dx = shape_.dx();
    for (std::size_t j = 0; j <= shape_.ny; ++j) {
        for (std::size_t i = 0; i <= shape_.nx; ++i) {
            const std::size_t k = index(i, j);
            const double y = shape_.node_y(i, j);
            if (j < shape_.ny) face_x_[k] = {1, 0, shape_.node_y(i, j + 1) - y};
            if (i == shape_.nx) continue;
            const double rise = shape_.node_y(i + 1, j) - y, length = std::hypot(dx, rise);
            face_y_[k] = {-rise / length, dx / length, length};
        }
    }
    for (std::size_t j = 0; j < shape_.ny; ++j) {
        for (std::size_t i = 0; i < shape_.nx; ++i)
            area_[index(i, j)] = dx * (face_x_[index(i, j)].length + face_x_[index(i + 1, j)].length) / 2;
    }
}

double FiniteVolumeChannel::y(std::size_t i, std::size_t j) const {
    return (shape_.node_y(i, j) + shape_.node_y(i + 1, j) + shape_.node_y(i, j + 1) +
            shape_.node_y(i + 1, j + 1)) /
           4;
}

const GasState2D& FiniteVolumeChannel::at_point(double x, double y) const {
    const double low = shape_.floor(x), high = shape_.ceiling(x);
    const auto cell = [](double share, std::size_t n) {
        const double k = std::floor(share * static_cast<double>(n));
        return static_cast<std::size_t>(std::clamp(k, 0.0, static_cast<double>(n - 1)));
    };
    return at(cell((x - shape_.x_begin) / (shape_.x_end - shape_.x_begin), shape_.nx),
              cell((y - low) / (high - low), shape_.ny));
}

/// What enters, what leaves, and the mirror images in the walls' faces.
void FiniteVolumeChannel::fill_ghosts() {
    const auto mirrored = [&](std::size_t ghost, std::size_t from, const Face& wall) {
        const double v = gas_[from].vx * wall.nx + gas_[from].vy * wall.ny;
        gas_[ghost] = gas_[from];
        gas_[ghost].vx -= 2 * v * wall.nx, gas_[ghost].vy -= 2 * v * wall.ny;
    };
    for (std::size_t j = 0; j < shape_.ny; ++j) {
        for (std::size_t k = 0; k < ghosts; ++k) {
            gas_[index(0, j) - k - 1] = entering_;
            gas_[index(shape_.nx, j) + k] = gas_[index(shape_.nx - 1, j)];
        }
    }
    for (std::size_t i = 0; i < shape_.nx; ++i) {
        for (std::size_t k = 0; k < ghosts; ++k) {
            mirrored(index(i, 0) - (k + 1) * stride_, index(i, k), face_y_[index(i, 0)]);
            mirrored(index(i, shape_.ny) + k * stride_, index(i, shape_.ny - 1 - k),
                     face_y_[index(i, shape_.ny)]);
        }
    }
}

FiniteVolumeChannel::Conserved FiniteVolumeChannel::flux(const GasState2D& low, const GasState2D& high,
                                                         const Face& face) {
    const auto along = [&](const GasState2D& s) { return s.vx * face.nx + s.vy * face.ny; };
    const auto across = [&](const GasState2D& s) { return s.vy * face.nx - s.vx * face.ny; };
    const hllc::Gas l{low.rho, along(low), low.p}, r{high.rho, along(high), high.p};
    const hllc::Fan fan = hllc::fan(l, r, gamma_);
    const hllc::Flux through = hllc::flux(l, r, fan, gamma_);
    const double t = across(fan.contact > 0 ? low : high);
    fastest_ = face.length * std::max(-fan.left, fan.right);
    return {face.length * through.mass,
            face.length * (through.momentum * face.nx - through.mass * t * face.ny),
            face.length * (through.momentum * face.ny + through.mass * t * face.nx),
            face.length * (through.energy + through.mass * t * t / 2)};
}

void FiniteVolumeChannel::find_fluxes() {
    fill_ghosts();
    std::fill(rate_.begin(), rate_.end(), 0);
    const auto slopes = [&](std::size_t k, std::size_t by) {
        return slope_between(gas_[k - by], gas_[k], gas_[k + by]);
    };
    for (std::size_t j = 0; j < shape_.ny; ++j) {
        for (std::size_t k = index(0, j) - 1; k <= index(shape_.nx, j); ++k) slope_x_[k] = slopes(k, 1);
    }
    for (std::size_t k = index(0, 0) - stride_; k <= index(shape_.nx - 1, shape_.ny); ++k)
        slope_y_[k] = slopes(k, stride_);
    const auto solve = [&](std::size_t k, std::size_t by, const auto& slope, const Face& face,
                           Conserved& out) {
        out = flux(moved(gas_[k - by], slope[k - by], 0.5), moved(gas_[k], slope[k], -0.5), face);
        rate_[k] += fastest_, rate_[k - by] += fastest_;
    };
    for (std::size_t j = 0; j < shape_.ny; ++j) {
        for (std::size_t k = index(0, j); k <= index(shape_.nx, j); ++k)
            solve(k, 1, slope_x_, face_x_[k], flux_x_[k]);
    }
    for (std::size_t j = 0; j <= shape_.ny; ++j) {
        for (std::size_t k = index(0, j); k < index(shape_.nx, j); ++k)
            solve(k, stride_, slope_y_, face_y_[k], flux_y_[k]);
    }
}

double FiniteVolumeChannel::mass_flux(std::size_t i) {
    find_fluxes();
    double sum = 0;
    for (std::size_t j = 0; j < shape_.ny; ++j) sum += flux_x_[index(i, j)][0];
    return sum;
}

FiniteVolumeChannel::Conserved FiniteVolumeChannel::conserved(const GasState2D& s) const {
    return {s.rho, s.rho * s.vx, s.rho * s.vy, s.p / (gamma_ - 1) + s.rho * (s.vx * s.vx + s.vy * s.vy) / 2};
}

void FiniteVolumeChannel::set(std::size_t k, const Conserved& value, const char* when) {
    const auto [rho, px, py, energy] = value;
    const double p = (gamma_ - 1) * (energy - (px * px + py * py) / (2 * rho));
    if (!(rho > 0 && p > 0)) {
        std::ostringstream text;
        text << "time " << time_ << ", " << when << " of a step: cell (" << k % stride_ - ghosts << ", "
             << k / stride_ - ghosts << "): density " << rho << ", pressure " << p;
        throw UnphysicalCell{text.str()};
    }
    gas_[k] = {rho, px / rho, py / rho, p};
}

/// Heun: the mean of the cells as they were and of two simple steps. Fluxes of the first are known.
void FiniteVolumeChannel::step(double dt) {
    const auto each = [&](auto&& visit) {
        for (std::size_t j = 0; j < shape_.ny; ++j) {
            for (std::size_t k = index(0, j); k < index(shape_.nx, j); ++k) {
                Conserved to = conserved(gas_[k]);
                for (std::size_t q = 0; q < 4; ++q)
                    to[q] -= dt / area_[k] *
                             (flux_x_[k + 1][q] - flux_x_[k][q] + flux_y_[k + stride_][q] - flux_y_[k][q]);
                visit(k, to);
            }
        }
    };
    each([&](std::size_t k, const Conserved& to) {
        before_[k] = conserved(gas_[k]);
        set(k, to, "the first half");
    });
    find_fluxes();
    each([&](std::size_t k, Conserved to) {
        for (std::size_t q = 0; q < 4; ++q) to[q] = (to[q] + before_[k][q]) / 2;
        set(k, to, "the second half");
    });
    ++steps_;
}

void FiniteVolumeChannel::advance_to(double t) {
    require(t >= time_ && std::isfinite(t), problem, "time", t, "the present one and later, finite");
    while (time_ < t) {
        find_fluxes();
        double fastest = 0;
        for (std::size_t j = 0; j < shape_.ny; ++j) {
            for (std::size_t k = index(0, j); k < index(shape_.nx, j); ++k)
                fastest = std::max(fastest, rate_[k] / area_[k]);
        }
        // Each wave is counted at both faces of a cell.
        const double dt = 2 * courant_ / fastest;
        const bool last = !(dt < t - time_);
        step(last ? t - time_ : dt);
        time_ = last ? t : time_ + dt;
    }
}

}  // namespace exact
