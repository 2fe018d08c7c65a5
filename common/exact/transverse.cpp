#include "common/exact/transverse.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include "common/exact/require.hpp"
#include "common/exact/transverse_net.hpp"

namespace exact {
namespace {

using transverse::Net;
using transverse::Node;

constexpr const char* problem = "transverse expansion";
constexpr int least_levels = 3, most_levels = 4;
constexpr int most_levels_if_fast = 6;  ///< for c2 > 0.4, where rapidities near the vacuum grow in few lines
constexpr double accurate = 1e-6;       ///< of T, by the last two extrapolations: enough levels
constexpr double outlier = 5e-6;        ///< of T: a row that does not converge
constexpr std::size_t stencil = 6, least_stencil = 4;

/// The value at x of the polynomial through the points (x_k, y_k), by Neville's scheme.
template <std::size_t n>
double through(std::size_t count, const std::array<double, n>& x_k, std::array<double, n> y_k, double x) {
    for (std::size_t l = 1; l < count; ++l)
        for (std::size_t k = 0; k + l < count; ++k)
            y_k[k] = ((x - x_k[k + l]) * y_k[k] + (x_k[k] - x) * y_k[k + 1]) / (x_k[k] - x_k[k + l]);
    return y_k[0];
}

/// Where a line outwards is late.
struct Crossing {
    static constexpr std::size_t size = 4;
    std::array<double, size> values;  ///< ln age, ln depth, psi, phi
    double log_age() const { return values[0]; }
    double log_depth() const { return values[1]; }
    double psi() const { return values[2]; }
    double phi() const { return values[3]; }
};

Crossing crossing(const Net::Late& late, std::span<const Node> row) {
    const std::size_t count = std::min(row.size(), stencil);
    std::array<double, stencil> x{};
    std::array<std::array<double, stencil>, Crossing::size> y{};
    for (std::size_t k = 0; k < count; ++k) {
        const Node& node = row[row.size() - count + k];
        x[k] = late(node);
        const std::array values{std::log(node.age), std::log(node.depth), node.psi, node.phi};
        for (std::size_t m = 0; m < values.size(); ++m) y[m][k] = values[m];
    }
    Crossing found{};
    for (std::size_t m = 0; m < y.size(); ++m) found.values[m] = through(count, x, y[m], 0);
    return found;
}

/// The crossings on all rows, on one level and extrapolated from it and those before.
using Crossings = std::map<std::size_t, Crossing>;

Crossings crossings(const Net& net, const Net::Late& late, double age) {
    Crossings all;
    net.walk(late, age, [&](std::size_t row, std::span<const Node> nodes) {
        if (nodes.size() >= least_stencil && late(nodes.back()) > 0) all[row] = crossing(late, nodes);
    });
    return all;
}

/// The errors of the coarser and the finer rows are as `ratio` to 1. Only rows that are in both.
Crossings extrapolated(const Crossings& coarse, const Crossings& fine, double ratio) {
    Crossings result;
    for (const auto& [row, value] : fine) {
        const auto other = coarse.find(row);
        if (other == coarse.end()) continue;
        Crossing& better = result[row] = value;
        for (std::size_t m = 0; m < Crossing::size; ++m)
            better.values[m] += (value.values[m] - other->second.values[m]) / (ratio - 1);
    }
    return result;
}

/// By how much a and b differ in T at a place, row by row; their rows also differ in place.
std::map<std::size_t, double> differences(const Crossings& a, const Crossings& b, double bjorken) {
    std::map<std::size_t, double> all;
    const Crossing* before = nullptr;
    for (const auto& [row, value] : b) {
        const auto other = a.find(row);
        const auto y = [](const Crossing& c) { return (c.psi() + c.phi()) / 2; };
        if (before != nullptr && other != a.end()) {
            const double rise = (y(value) - y(*before)) / (value.log_depth() - before->log_depth());
            const double moved = value.log_depth() - other->second.log_depth();
            all[row] = bjorken * std::exp(y(value)) * std::fabs(y(value) - y(other->second) - rise * moved);
        }
        before = &value;
    }
    return all;
}

struct Extrapolation {
    Crossings rows;
    double error;
};

/// Errors are series in the square of the lines' distance. Rows that become late in one long step, as some
/// near the vacuum, do not obey this, and are left out.
Extrapolation extrapolate(const TransverseFlow& flow, const Net::Late& late, double age, double bjorken) {
    std::vector<Crossings> column;  // the last row of Richardson's table, least extrapolated first
    Extrapolation best{{}, 0};
    const int most = flow.c2 > 0.4 ? most_levels_if_fast : most_levels;
    for (int level = 0; level < most; ++level) {
        std::vector<Crossings> next{crossings({flow.radius, flow.tau0, flow.c2, level}, late, age)};
        double ratio = 1;
        for (const Crossings& coarse : column) next.push_back(extrapolated(coarse, next.back(), ratio *= 4));
        if (level + 1 >= least_levels) {
            best = {{}, 0};
            std::size_t left_out = 0;
            for (const auto& [row, error] : differences(column.back(), next.back(), bjorken)) {
                if (error < outlier) {
                    best.rows[row] = next.back()[row];
                    best.error = std::fmax(best.error, error);
                } else {
                    ++left_out;
                }
            }
            if (left_out == 0 && best.error < accurate) break;
        }
        column = std::move(next);
    }
    return best;
}

constexpr std::size_t unreliable = 5;  ///< rows after the first, which is plane flow until it meets all lines

/// Leaves out what rounding has put behind the last one.
template <class Point>
void append(std::vector<Point>& table, const Point& point) {
    if (table.empty() || point.x > table.back().x) table.push_back(point);
}

/// psi and phi at x, by a polynomial; below the first point by a line.
template <class Point>
Point interpolated(const std::vector<Point>& table, double x) {
    std::size_t count = std::min(table.size(), stencil), first = 0;
    if (x < table.front().x) {
        count = std::min<std::size_t>(count, 2);
    } else {
        const auto above = std::lower_bound(table.begin(), table.end(), x,
                                            [](const Point& p, double at) { return p.x < at; });
        const auto k = static_cast<std::size_t>(above - table.begin());
        first = std::min(k > stencil / 2 ? k - stencil / 2 : 0, table.size() - count);
    }
    std::array<double, stencil> x_k{}, psi{}, phi{};
    for (std::size_t k = 0; k < count; ++k) {
        x_k[k] = table[first + k].x;
        psi[k] = table[first + k].psi;
        phi[k] = table[first + k].phi;
    }
    return {x, through(count, x_k, psi, x), through(count, x_k, phi, x)};
}

/// The tau of the surface on the axis, from its last events: it is even in r.
double on_axis(std::span<const SurfaceEvent> events) {
    constexpr std::size_t used = 4;
    const std::size_t count = std::min(used, events.size());
    std::array<double, used> square{}, tau{};
    for (std::size_t k = 0; k < count; ++k) {
        const auto& [at, r] = events[events.size() - count + k];
        square[k] = r * r, tau[k] = at;
    }
    return through(count, square, tau, 0);
}

}  // namespace

void TransverseFlow::check() const {
    require(radius >= 1e-6 && radius <= 1e6, problem, "radius", radius, "1e-6..1e6");
    require(tau0 >= 1e-4 * radius && tau0 <= 1e4 * radius, problem, "tau0", tau0, "1e-4..1e4 radii");
    require(c2 >= 0.01 && c2 <= 0.5, problem, "sound speed squared", c2, "0.01..0.5");
}
double TransverseFlow::sound_speed() const {
    return std::sqrt(c2);
}
double TransverseFlow::axis_time() const {
    return tau0 + radius / sound_speed();
}
double TransverseFlow::last_time() const {
    return tau0 + 4 * radius / sound_speed();
}
double TransverseFlow::edge(double tau) const {
    return radius + (tau - tau0);
}
double TransverseFlow::head(double tau) const {
    return std::fmax(0, radius - sound_speed() * (tau - tau0));
}
double TransverseFlow::bjorken(double tau) const {
    return std::pow(tau0 / tau, c2);
}

TransverseProfile::TransverseProfile(const TransverseFlow& flow, double tau) : flow_{flow}, tau_{tau} {
    flow.check();
    require(tau >= flow.tau0 && tau <= flow.last_time(), problem, "tau", tau, "tau0..tau0 + 4 radius/c0");
    const double age = tau - flow.tau0;
    inner_end_ = flow.head(tau);
    if (age <= 0) return;
    const auto late = [&](const Node& n) { return std::log(n.age / age); };
    const auto [rows, error] = extrapolate(flow, late, age, flow.bjorken(tau));
    error_ = error;
    const std::size_t front = Net{flow.radius, flow.tau0, flow.c2}.rows_from_head(age) - 1;
    for (const auto& [row, line] : rows) {
        if (row >= unreliable && row <= front) append(outer_, {line.log_depth(), line.psi(), line.phi()});
        if (row < front) continue;
        const double r = flow.edge(tau) - std::exp(line.log_depth());
        append(inner_, {-r, line.phi(), line.psi()});
        if (row == front) inner_end_ = r;
    }
    if (inner_.empty()) append(outer_, {std::log(age * (1 + flow.sound_speed())), 0, 0});
    for (std::size_t k = inner_.size(); k-- > 0;)
        inner_.push_back({-inner_[k].x, inner_[k].phi, inner_[k].psi});
}

/// psi and phi at r.
TransverseProfile::Point TransverseProfile::at_point(double r) const {
    if (r < inner_end_) return inner_.empty() ? Point{r, 0, 0} : interpolated(inner_, r);
    return interpolated(outer_, std::log(depth(r)));
}

TransverseProfile::State TransverseProfile::at(double r) const {
    require(r >= 0 && std::isfinite(r), problem, "r", r, "the finite numbers from 0 on");
    if (tau_ == flow_.tau0 ? r > flow_.radius : depth(r) <= 0) return {0, 0, 0};
    const Point point = outer_.empty() ? Point{r, 0, 0} : at_point(r);
    const double temperature = flow_.bjorken(tau_) * std::exp((point.psi + point.phi) / 2);
    const double rapidity = (point.psi - point.phi) / (2 * flow_.sound_speed());
    return {temperature, rapidity, tau_ * std::pow(temperature, 1 / flow_.c2) * std::cosh(rapidity)};
}

double lowest_surface(const TransverseFlow& flow) {
    return std::exp(-5 * flow.sound_speed());
}

std::vector<SurfaceEvent> freeze_out_surface(const TransverseFlow& flow, double temperature) {
    flow.check();
    require(temperature >= lowest_surface(flow) && temperature < 1, problem, "temperature", temperature,
            "[e^(-5 c0), 1)");
    const auto late = [&](const Node& n) {
        return std::log(temperature) - (n.psi + n.phi) / 2 + flow.c2 * std::log1p(n.age / flow.tau0);
    };
    const double age = flow.tau0 * std::expm1(-std::log(temperature) / flow.c2);  // of Bjorken's flow
    const auto [rows, error] =
        extrapolate(flow, late, std::fmin(age, 4 * flow.radius / flow.sound_speed()), 1);
    std::vector<SurfaceEvent> events{{flow.tau0, flow.radius}};
    for (const auto& [row, line] : rows) {
        const double at = std::exp(line.log_age());
        events.push_back({flow.tau0 + at, flow.radius + (at - std::exp(line.log_depth()))});
    }
    if (flow.tau0 + age <= flow.axis_time()) {
        events.push_back({flow.tau0 + age, flow.head(flow.tau0 + age)});
        events.push_back({flow.tau0 + age, 0});
    } else {
        events.push_back({on_axis(events), 0});
    }
    return events;
}

}  // namespace exact
