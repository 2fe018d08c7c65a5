#pragma once
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>

/// The ways to tell a velocity v, |v| < 1 = c: the Lorentz factor W = 1/sqrt(1 - v^2) and the four-velocity
/// W v. Of v near 1 no more is known than 1e-16 W^2.
namespace exact::relativistic {

inline double lorentz_factor(double v) {
    return 1 / std::sqrt((1 - v) * (1 + v));
}
inline double four_velocity(double v) {
    return v / std::sqrt((1 - v) * (1 + v));
}

/// v of a Lorentz factor that has the sign of v. Throws std::domain_error for -1 < W < 1.
inline double velocity_of_lorentz(double W) {
    if (!(std::abs(W) >= 1))
        throw std::domain_error{
            "a Lorentz factor between -1 and 1 is not allowed; allowed: 1 and above, or -1 "
            "and below (the sign is that of the velocity)"};
    return std::copysign(std::sqrt((1 - 1 / W) * (1 + 1 / W)), W);
}
inline double velocity_of_four_velocity(double U) {
    return U / std::sqrt(1 + U * U);
}

/// The ways by their names on command lines, and what makes v of each.
inline const std::map<std::string, std::function<double(double)>>& velocities() {
    static const std::map<std::string, std::function<double(double)>> all{
        {"v", [](double v) { return v; }},
        {"lorentz", velocity_of_lorentz},
        {"four-velocity", velocity_of_four_velocity}};
    return all;
}

}  // namespace exact::relativistic
