#include "common/core/unstable.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace sph {
namespace {

std::string shown(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
}

}  // namespace

Unstable::Unstable(double t, std::size_t i, std::string name, double what)
    : app::UnphysicalError{"unphysical state at t = " + shown(t) + ": " + name +
                           (i == no_particle ? std::string{} : " of particle " + std::to_string(i)) + " is " +
                           shown(what)},
      time{t},
      particle{i},
      quantity{std::move(name)},
      value{what} {}

void require_physical(std::span<const double> values, std::string_view quantity, bool positive, double t) {
    constexpr double largest = std::numeric_limits<double>::max();
    const auto sound = [positive](double value) {
        return (positive ? value > 0 : value >= -largest) && value <= largest;  // false for NaN
    };
    int wrong = 0;
    for (const double value : values) wrong |= sound(value) ? 0 : 1;
    if (wrong == 0) return;
    std::size_t i = 0;
    while (sound(values[i])) ++i;
    throw Unstable{t, i, std::string{quantity}, values[i]};
}

void require_time_step(double t, double dt) {
    if (!std::isfinite(dt) || t + dt == t) throw Unstable{t, Unstable::no_particle, "the time step", dt};
}

void require_order(std::span<const double> x, double t) {
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        const double gap = x[i + 1] - x[i];
        if (!(gap > 0)) throw Unstable{t, i, "the distance to the next particle", gap};
    }
}

}  // namespace sph
