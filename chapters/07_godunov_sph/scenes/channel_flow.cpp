#include "chapters/07_godunov_sph/scenes/channel_flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace sph::godunov {
namespace {

constexpr double degrees = std::numbers::pi / 180;

/// How far a place is from a ray that leaves (x0, y0) at an angle; > 0 on its right.
double right_of(double x, double y, double x0, double y0, double inclination) {
    return (x - x0) * std::sin(inclination) - (y - y0) * std::cos(inclination);
}

/// The mean of value(i, j) over the cells of which `holds(x, y)`.
template <class Value, class Holds>
double mean_over(const ChannelFlow& flow, const Value& value, const Holds& holds) {
    double sum = 0, count = 0;
    for (std::size_t j = 0; j < flow.cells.ny; ++j) {
        for (std::size_t i = 0; i < flow.cells.nx; ++i) {
            if (!holds(flow.x(i), flow.y(i, j))) continue;
            sum += value(i, j);
            ++count;
        }
    }
    return sum / count;
}

/// The angle of the shock from the edge.
double shock_angle(const WedgeChannel& channel, const ChannelFlow& flow) {
    constexpr double lowest = 0.15, highest = 0.7;
    const double slope = std::tan(channel.shock().beta());
    const double level = channel.pressure() * (1 + channel.shock().p_ratio()) / 2;
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < flow.cells.nx; ++i) {
        const double x = flow.x(i), wanted = (x - channel.edge) * slope;
        if (wanted < lowest || wanted > highest) continue;
        for (std::size_t j = flow.cells.ny - 1; j > 0; --j) {
            const double above = flow.at(i, j).p, below = flow.at(i, j - 1).p;
            if (above > level || below <= level) continue;
            const double share = (level - above) / (below - above);
            const double y = (1 - share) * flow.y(i, j) + share * flow.y(i, j - 1);
            ++n, sx += x, sy += y, sxx += x * x, sxy += x * y;
            break;
        }
    }
    return std::atan((n * sxy - sx * sy) / (n * sxx - sx * sx)) / degrees;
}

}  // namespace

double WedgeChannel::radians() const {
    return angle * degrees;
}
double WedgeChannel::floor(double x) const {
    return (std::clamp(x, edge, corner) - edge) * std::tan(radians());
}
std::vector<PolygonWall> WedgeChannel::walls() const {
    const double top = floor(corner);
    return {PolygonWall{{{begin, 0}, {edge, 0}, {corner, top}, {end, top}}},
            PolygonWall{{{end, 1}, {begin, 1}}}};
}
exact::ChannelShape WedgeChannel::cells(std::size_t n) const {
    return {begin, end, [channel = *this](double x) { return channel.floor(x); }, [](double) { return 1.0; },
            3 * n, n};
}
exact::ObliqueShock WedgeChannel::shock() const {
    return {mach, radians(), gamma};
}
exact::PrandtlMeyer WedgeChannel::fan() const {
    return {shock().mach_behind(), radians(), gamma};
}

double WedgeChannel::exact_mach(double x, double y) const {
    if (right_of(x, y, edge, 0, shock().beta()) < 0) return mach;
    const double above = y - floor(corner);
    if (x < corner && above <= 0) return shock().mach_behind();
    return fan().mach_on_ray(std::atan2(above, x - corner) - radians());
}

double ChannelFlow::y(std::size_t i, std::size_t j) const {
    return (cells.node_y(i, j) + cells.node_y(i + 1, j) + cells.node_y(i, j + 1) +
            cells.node_y(i + 1, j + 1)) /
           4;
}
double ChannelFlow::mach(std::size_t i, std::size_t j) const {
    const auto& [rho, vx, vy, p] = at(i, j);
    return std::hypot(vx, vy) / std::sqrt(gamma * p / rho);
}

namespace {
/// The centres of two cells beside a place, and the part of the second.
struct CellPair {
    std::size_t first, second;
    double share;
};
CellPair cells_beside(double place, std::size_t n) {
    const double at = std::clamp(place * static_cast<double>(n) - 0.5, 0.0, static_cast<double>(n - 1));
    const auto first = static_cast<std::size_t>(at);
    return {first, std::min(first + 1, n - 1), at - std::floor(at)};
}
struct CellsAround {
    CellPair x, y;
};
CellsAround place_of(const exact::ChannelShape& cells, double x, double y) {
    const double low = cells.floor(x), high = cells.ceiling(x);
    return {cells_beside((x - cells.x_begin) / (cells.x_end - cells.x_begin), cells.nx),
            cells_beside((y - low) / (high - low), cells.ny)};
}
/// Calls visit(i, j, weight) for the four cells around a place.
template <class Visit>
void around(const CellsAround& place, const Visit& visit) {
    const auto& [a, b] = place;
    visit(a.first, b.first, (1 - a.share) * (1 - b.share));
    visit(a.second, b.first, a.share * (1 - b.share));
    visit(a.first, b.second, (1 - a.share) * b.share);
    visit(a.second, b.second, a.share * b.share);
}
}  // namespace

double ChannelFlow::mach_at(double at_x, double at_y) const {
    double sum = 0;
    around(place_of(cells, at_x, at_y),
           [&](std::size_t i, std::size_t j, double weight) { sum += weight * mach(i, j); });
    return sum;
}

ChannelFlow flow_of(const exact::FiniteVolumeChannel& grid, double gamma) {
    ChannelFlow flow{grid.shape(), {}, gamma};
    for (std::size_t j = 0; j < flow.cells.ny; ++j) {
        for (std::size_t i = 0; i < flow.cells.nx; ++i) flow.state.push_back(grid.at(i, j));
    }
    return flow;
}

FlowMean::FlowMean(const exact::ChannelShape& cells)
    : cells_{cells}, sum_(cells.nx * cells.ny), weight_(cells.nx * cells.ny) {}

void FlowMean::add(double x, double y, double volume, const exact::GasState2D& state) {
    if (x < cells_.x_begin || x > cells_.x_end) return;
    around(place_of(cells_, x, y), [&](std::size_t i, std::size_t j, double part) {
        const std::size_t k = j * cells_.nx + i;
        const double weight = part * volume;
        weight_[k] += weight;
        sum_[k].rho += weight * state.rho, sum_[k].p += weight * state.p;
        sum_[k].vx += weight * state.vx, sum_[k].vy += weight * state.vy;
    });
}

ChannelFlow FlowMean::mean(double gamma) const {
    ChannelFlow flow{cells_, sum_, gamma};
    for (std::size_t k = sum_.size(); k-- > 0;) {
        auto& [rho, vx, vy, p] = flow.state[k];
        if (weight_[k] > 0) {
            rho /= weight_[k], vx /= weight_[k], vy /= weight_[k], p /= weight_[k];
        } else {
            flow.state[k] = flow.state[std::min(k + 1, sum_.size() - 1)];
        }
    }
    return flow;
}

Measured measure(const WedgeChannel& channel, const ChannelFlow& flow) {
    constexpr double from_floor = 0.05, after_begin = 0.25, after_end = 0.6;
    const double mach_behind = channel.shock().mach_behind(), mach_after = channel.fan().mach_behind();
    const double top = channel.floor(channel.corner), angle = channel.radians(),
                 beta = channel.shock().beta();
    const double from_wave = 0.3 * right_of(channel.corner, top, channel.edge, 0, beta);
    const auto mach = [&](std::size_t i, std::size_t j) { return flow.mach(i, j); };
    const double exact_entropy =
        channel.pressure() * channel.shock().p_ratio() / std::pow(channel.shock().rho_ratio(), channel.gamma);
    const auto entropy = [&](std::size_t i, std::size_t j) {
        return flow.at(i, j).p / std::pow(flow.at(i, j).rho, channel.gamma) / exact_entropy;
    };
    const double row = (1 - top) / static_cast<double>(flow.cells.ny);
    const auto after = [&](double x) { return x > after_begin && x < after_end; };
    Measured measured;
    measured.beta = shock_angle(channel, flow);
    measured.mach_behind = mean_over(flow, mach, [&](double x, double y) {
        return right_of(x, y, channel.edge, 0, beta) > from_wave &&
               right_of(x, y, channel.corner, top, angle + std::asin(1 / mach_behind)) < -from_wave &&
               y - channel.floor(x) > from_floor;
    });
    measured.mach_after = mean_over(flow, mach, [&](double x, double y) {
        return right_of(x, y, channel.corner, top, std::asin(1 / mach_after)) > from_wave && after(x) &&
               y - top > from_floor;
    });
    measured.entropy_at_floor =
        mean_over(flow, entropy, [&](double x, double y) { return after(x) && y - top < row; });
    measured.entropy_above = mean_over(
        flow, entropy, [&](double x, double y) { return after(x) && y - top > 0.15 && y - top < 0.2; });
    measured.least_mach = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < flow.cells.ny; ++j) {
        for (std::size_t i = 0; i < flow.cells.nx; ++i) {
            if (mach(i, j) < measured.least_mach)
                measured.least_mach = mach(i, j), measured.least_x = flow.x(i);
        }
    }
    const auto slower = [&](std::size_t j) {
        for (std::size_t i = 0; i < flow.cells.nx; ++i) {
            if (flow.mach(i, j) < 1) return true;
        }
        return false;
    };
    std::size_t rows = 0;
    while (rows < flow.cells.ny && slower(flow.cells.ny - 1 - rows)) ++rows;
    measured.sonic_height = static_cast<double>(rows) * (1 - top) / static_cast<double>(flow.cells.ny);
    return measured;
}

}  // namespace sph::godunov
