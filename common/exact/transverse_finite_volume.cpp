#include "common/exact/transverse_finite_volume.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "common/exact/finite_volume_steps.hpp"
#include "common/exact/relativistic_hllc.hpp"
#include "common/exact/require.hpp"

namespace exact {
namespace {

constexpr const char* problem = "finite-volume solver in rings";
constexpr double equal = 1e-6;        ///< relative difference of widths that are equal but for rounding
constexpr double longest_step = 0.1;  ///< of tau: the fluid thins as 1/tau

/// d(primitive)/d tau times a ring's width, from the differences dq across it, as BaryonFreeFluid::rates;
/// `spread` is v/r + 1/tau times the width.
BaryonFreeFluid::Values rates(double c2, const BaryonFreeFluid::Values& q, const BaryonFreeFluid::Values& dq,
                              double face, double spread) {
    const relativistic::Motion m{q[0]};
    const double per = c2 / (1 - m.v * m.v * c2);
    const relativistic::Rates plane{m, dq[0], 4 * c2 / (1 + c2) * dq[1] / q[1], c2};
    const double push = per * m.v * spread, theta = plane.theta + m.v * push + spread;
    return {plane.dz_dt + push * m.lorentz + face * dq[0],
            (face - m.v) * dq[1] - (1 + c2) / 4 * q[1] * theta};
}

}  // namespace

TransverseFiniteVolume::TransverseFiniteVolume(const FluidCells& initial, const BaryonFreeFluid& fluid,
                                               const TransverseFiniteVolumeOptions& options)
    : fluid_{fluid},
      options_{options},
      n_{initial.size()},
      width_{initial.faces.empty() ? 0 : initial.faces.back() / static_cast<double>(n_)},
      tau_{options.tau0},
      west_(n_ + 2),
      east_(n_ + 2),
      pressure_(n_ + 2) {
    fluid_.check();
    require(n_ >= 2, problem, "number of rings", static_cast<double>(n_), "2 and above");
    require(initial.faces.size() == n_ + 1 && initial.faces.front() == 0, problem, "first face",
            initial.faces.front(), "0, the axis");
    require(options.tau0 > 0 && std::isfinite(options.tau0), problem, "tau0", options.tau0,
            "the finite numbers above 0");
    require(options.courant > 0 && options.courant <= 1, problem, "courant", options.courant, "(0, 1]");
    require(options.expansion >= 0 && options.expansion * initial.faces.back() <= 1, problem, "expansion",
            options.expansion, "0..1/end");
    for (std::size_t i = 0; i < n_; ++i) {
        require(std::abs(initial.width(i) - width_) <= equal * width_, problem, "width of a ring",
                initial.width(i), "the numbers above 0 that all rings share");
        fluid_.check(initial.states[i]);
        primitive_.push_back(fluid_.primitive(initial.states[i]));
        conserved_.push_back(fluid_.conserved(primitive_.back(), relativistic::Motion{primitive_.back()[0]}));
    }
    next_ = primitive_;
}

double TransverseFiniteVolume::measure(std::size_t i, double tau) const {
    const double west = face(static_cast<double>(i), tau), east = face(static_cast<double>(i + 1), tau);
    return tau * (east - west) * (east + west) / 2;
}

TransverseFiniteVolume::Values TransverseFiniteVolume::ring(std::ptrdiff_t i) const {
    if (i < 0) {
        const Values& image = primitive_[static_cast<std::size_t>(-1 - i)];
        return {-image[0], image[1]};
    }
    return primitive_[std::min(static_cast<std::size_t>(i), n_ - 1)];
}

void TransverseFiniteVolume::predict(double dt) {
    const double width = width_ * scale(tau_), half = dt / 2 / width;
    for (std::size_t k = 0; k < n_ + 2; ++k) {
        const auto i = static_cast<std::ptrdiff_t>(k) - 1;
        const double centre = static_cast<double>(i) + 0.5;
        const Values q = ring(i), before = ring(i - 1), after = ring(i + 1);
        Values dq{};
        for (std::size_t m = 0; m < q.size(); ++m)
            dq[m] = hllc::limited(q[m] - before[m], after[m] - q[m], 0.5, 0.5);
        const double spread = (relativistic::Motion{q[0]}.v / (centre * width) + 1 / tau_) * width;
        const Values rate = rates(fluid_.c2, q, dq, options_.expansion * width_ * centre, spread);
        const bool keep = q[1] + half * rate[1] - std::abs(dq[1]) / 2 > steps::least * q[1];
        Values mid = q;
        if (keep)
            mid = {q[0] + half * rate[0], q[1] + half * rate[1]};
        else
            dq = {0, 0};
        west_[k] = {mid[0] - dq[0] / 2, mid[1] - dq[1] / 2};
        east_[k] = {mid[0] + dq[0] / 2, mid[1] + dq[1] / 2};
        pressure_[k] = fluid_.pressure(mid);
    }
}

bool TransverseFiniteVolume::attempt(double dt) {
    predict(dt);
    const double mid = tau_ + dt / 2, after = tau_ + dt;
    const auto flux = [&](std::size_t i) -> Values {
        const auto l = relativistic::side(fluid_, east_[i]), r = relativistic::side(fluid_, west_[i + 1]);
        const double speed = options_.expansion * width_ * static_cast<double>(i);
        return relativistic::flux(l, r, relativistic::fan(l, r), speed);
    };
    Values west = flux(0);
    for (std::size_t i = 0; i < n_; ++i) {
        const Values east = flux(i + 1);
        const double r_west = face(static_cast<double>(i), mid),
                     r_east = face(static_cast<double>(i + 1), mid);
        const double p = pressure_[i + 1];
        const Values source{mid * p * (r_east - r_west), -measure(i, mid) / mid * p};
        for (std::size_t m = 0; m < west.size(); ++m) {
            const double through = mid * (r_east * east[m] - r_west * west[m]);
            next_[i][m] =
                (conserved_[i][m] * measure(i, tau_) + dt * (source[m] - through)) / measure(i, after);
        }
        west = east;
    }
    return std::all_of(next_.begin(), next_.end(), [](const Values& u) { return u[1] > std::abs(u[0]); });
}

double TransverseFiniteVolume::fastest() const {
    double rate = 0;
    for (std::size_t i = 0; i < n_; ++i) {
        const auto side = relativistic::side(fluid_, primitive_[i]);
        const double speed = options_.expansion * width_ * (static_cast<double>(i) + 0.5);
        rate = std::max({rate, side.fast - speed, speed - side.slow});
    }
    return rate / (width_ * scale(tau_));
}

void TransverseFiniteVolume::advance_to(double tau) {
    require(tau >= tau_ && std::isfinite(tau), problem, "tau", tau, "the present one and later, finite");
    while (tau_ < tau) {
        double dt = options_.courant * (steps_ < steps::slow_steps ? steps::slow_start : 1) / fastest();
        dt = std::min({dt, longest_step * tau_, tau - tau_});
        for (int repeats = 0; !attempt(dt); ++repeats, dt /= 2) {
            if (repeats < steps::most_repeats) continue;
            std::ostringstream text;
            text << "tau " << tau_ << ": a ring has no pressure";
            throw UnphysicalCell{text.str()};
        }
        tau_ = dt < tau - tau_ ? tau_ + dt : tau;
        ++steps_;
        std::swap(conserved_, next_);
        for (std::size_t i = 0; i < n_; ++i) {
            auto& [momentum, energy] = conserved_[i];
            auto& [z, root] = primitive_[i];
            fluid_.recover(1, {&momentum, &energy}, {&z, &root});
        }
    }
}

FluidCells TransverseFiniteVolume::cells() const {
    FluidCells cells{{0}, {}};
    for (std::size_t i = 0; i < n_; ++i) {
        cells.faces.push_back(face(static_cast<double>(i + 1), tau_));
        cells.states.push_back(fluid_.state(primitive_[i]));
    }
    return cells;
}

FluidCells disc(double radius, double end, std::size_t n, double outside) {
    require(radius > 0 && end > radius, problem, "end", end, "above the radius, which is above 0");
    FluidCells cells{{0}, {}};
    for (std::size_t i = 0; i < n; ++i) {
        cells.faces.push_back(std::lerp(0, end, static_cast<double>(i + 1) / static_cast<double>(n)));
        const double west = cells.faces[i], east = cells.faces[i + 1];
        const double inside =
            std::clamp((radius * radius - west * west) / (east * east - west * west), 0.0, 1.0);
        cells.states.push_back({std::lerp(outside, 1, inside), 0});
    }
    return cells;
}

}  // namespace exact
