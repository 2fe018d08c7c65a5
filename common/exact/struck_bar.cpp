#include "common/exact/struck_bar.hpp"

#include <cmath>
#include <numbers>

#include "common/exact/require.hpp"

namespace exact {
namespace {

using std::numbers::pi;
constexpr const char* problem = "struck bar";

}  // namespace

StruckBar::StruckBar(int masses, int struck, double velocity)
    : masses_{masses}, struck_{struck}, velocity_{velocity} {
    require(masses >= 1 && masses <= most_masses, problem, "masses", masses, "1..100000");
    require(struck >= 1 && struck <= masses, problem, "struck mass", struck, "1..masses");
    require(std::abs(velocity) <= largest_velocity, problem, "velocity", velocity, "-1e50..1e50");
}

double StruckBar::frequency(int mode) const {
    require(mode >= 1 && mode <= masses_, problem, "mode", mode, "1..masses");
    return 2 * std::sin(mode * pi / (2.0 * (masses_ + 1)));
}

double StruckBar::sum_of_modes(int mass, double t, bool rate) const {
    require(mass >= 0 && mass <= masses_ + 1, problem, "mass", mass, "0..masses + 1");
    require(t >= 0 && t <= largest_time, problem, "time", t, "0..1e6");
    double sum = 0;
    for (int mode = 1; mode <= masses_; ++mode) {
        const double k = mode * pi / (masses_ + 1), omega = frequency(mode);
        const double in_time = rate ? std::cos(omega * t) : std::sin(omega * t) / omega;
        sum += std::sin(k * struck_) * std::sin(k * mass) * in_time;
    }
    return 2 * velocity_ / (masses_ + 1) * sum;
}

double StruckBar::displacement(int mass, double t) const {
    return sum_of_modes(mass, t, false);
}
double StruckBar::velocity(int mass, double t) const {
    return sum_of_modes(mass, t, true);
}

}  // namespace exact
