#pragma once
#include <cmath>
#include <stdexcept>

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

}  // namespace exact::relativistic
