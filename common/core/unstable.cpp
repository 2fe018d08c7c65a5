#include "common/core/unstable.hpp"

#include <array>
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

}  // namespace sph
