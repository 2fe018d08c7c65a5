#pragma once
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "common/app/error.hpp"
#include "common/core/particles.hpp"

namespace sph {

/// A simulation has left physics: a state that is not finite, a density or energy that is not positive, a
/// time step that has collapsed. Ends a program with exit status 3.
struct Unstable : app::UnphysicalError {
    static constexpr std::size_t no_particle = std::numeric_limits<std::size_t>::max();

    double time;
    std::size_t particle;  ///< no_particle where the quantity is not one particle's
    std::string quantity;
    double value;

    Unstable(double time, std::size_t particle, std::string quantity, double value);
};

/// Throws Unstable for the first value of the listed columns that is not finite, or not positive where the
/// column says that it must be. Cost: one pass over these columns.
template <class P, class... C>
void require_physical(const P& particles, double t, List<C...>) {
    [[maybe_unused]] const auto check = [&]<class Name>(Name, const Column& column) {
        constexpr bool positive = requires {
            Name::positive;
        };
        constexpr double largest = std::numeric_limits<double>::max();
        const auto sound = [](double value) {
            return (positive ? value > 0 : value >= -largest) && value <= largest;  // false for NaN
        };
        int wrong = 0;
        for (const double value : column) wrong |= sound(value) ? 0 : 1;
        if (wrong == 0) return;
        std::size_t i = 0;
        while (sound(column[i])) ++i;
        throw Unstable{t, i, std::string{Name::name}, column[i]};
    };
    (for_each_component([&](const Column& column) { check(C{}, column); },
                        member<C, Column, P::d>(particles)),
     ...);
}

/// Throws Unstable unless `dt` still moves the time on.
inline void require_time_step(double t, double dt) {
    if (!std::isfinite(dt) || t + dt == t) throw Unstable{t, Unstable::no_particle, "the time step", dt};
}

}  // namespace sph
