#include "common/exact/landau.hpp"

#include <cmath>
#include <numbers>

#include "common/exact/require.hpp"

namespace exact {
namespace {

using std::numbers::sqrt3;

constexpr const char* problem = "Landau slab";

LandauSlab::State moving(double omega, double y) {
    const double lorentz = std::cosh(y);
    return {lorentz * std::exp(-3 * omega), std::exp(-4 * omega), y, std::exp(-omega), std::tanh(y), lorentz};
}

/// The simple wave, or what is beside it, at x >= 0. With (x - 1)/t = tanh(y - artanh c_s):
///     e^(2y) = (1 + c_s)/(1 - c_s) inside/outside,   e^(2y) - 1 = (3 + sqrt3) ahead/outside.
struct Wave {
    double outside;  ///< 1 + t - x: the way to the edge, exact where it is short, as x - 1 is
    double inside;   ///< t - 1 + x
    double ahead;    ///< x - (1 - c_s t), the way from the fluid at rest

    Wave(double x, double t) : outside{t - (x - 1)}, inside{t + (x - 1)}, ahead{(x - 1) + t / sqrt3} {}

    bool in_vacuum() const { return outside <= 0; }
    bool in_fluid_at_rest() const { return ahead <= 0; }
    double y() const { return std::log1p((3 + sqrt3) * ahead / outside) / 2; }
    /// The entropy beyond x, t s sinh(artanh c_s)/cosh(artanh((x - 1)/t)).
    double entropy_beyond() const {
        return std::exp(-sqrt3 * y()) * std::sqrt(outside) * std::sqrt(inside / 2);
    }
};

}  // namespace

LandauSlab::LandauSlab(double t) : t_{t}, matching_{1 - t / sqrt3} {
    require(t >= 0 && t <= largest_time, problem, "time", t, "0..1e6");
    if (!waves_have_met()) return;
    outer_ = khalatnikov::weak_discontinuity(t);
    matching_ = std::fmax(1 + t * std::tanh(outer_.y - std::atanh(1 / sqrt3)), 0);
    outer_eta_ = std::atanh(matching_ / t);
    centre_ = khalatnikov::state_at(t, 0, {outer_.omega, 0});
}

LandauSlab::Zone LandauSlab::zone(double distance) const {
    const Wave wave{distance, t_};
    if (waves_have_met() && distance < matching_) return Zone::middle;
    if (!waves_have_met() && wave.in_fluid_at_rest()) return Zone::at_rest;
    return wave.in_vacuum() ? Zone::vacuum : Zone::wave;
}

khalatnikov::State LandauSlab::middle(double distance) const {
    const double part = std::atanh(distance / t_) / outer_eta_;
    return khalatnikov::state_at(
        t_, distance, {centre_.omega + part * part * (outer_.omega - centre_.omega), part * outer_.y});
}

LandauSlab::State LandauSlab::right_side(double distance) const {
    switch (zone(distance)) {
        case Zone::middle: {
            const auto [omega, y] = middle(distance);
            return moving(omega, y);
        }
        case Zone::at_rest:
            return {1, 1, 0, 1, 0, 1};
        case Zone::wave: {
            const double y = Wave{distance, t_}.y();
            return moving(y / sqrt3, y);
        }
        case Zone::vacuum:
            break;
    }
    return {0, 0, 0, 0, 0, 1};
}

LandauSlab::State LandauSlab::at(double x) const {
    require(std::isfinite(x), problem, "x", x, "the finite numbers");
    State state = right_side(std::fabs(x));
    if (x < 0) {
        state.rapidity = 0 - state.rapidity;  // 0 without a sign where the fluid rests
        state.velocity = 0 - state.velocity;
    }
    return state;
}

double LandauSlab::entropy_beyond(double distance) const {
    switch (zone(distance)) {
        case Zone::middle:
            return khalatnikov::entropy_beyond(middle(distance));
        case Zone::at_rest:
            return 1 - distance;
        case Zone::wave:
            return Wave{distance, t_}.entropy_beyond();
        case Zone::vacuum:
            break;
    }
    return 0;
}

double LandauSlab::entropy_left_of(double x) const {
    require(std::isfinite(x), problem, "x", x, "the finite numbers");
    const double beyond = entropy_beyond(std::fabs(x));
    return x < 0 ? beyond : 2 - beyond;
}

}  // namespace exact
