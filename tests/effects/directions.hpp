#pragma once
#include <array>
#include <vector>

#include "tests/effects/numbers.hpp"

/// The sign of an effect. A pressure pushes particles apart, friction acts against their relative velocity,
/// heat flows to the colder one: a term follows something, and never goes the other way.
namespace sph::tested {

/// What i and j differ in: place and velocity of i seen from j, and how much more j has than i.
struct Between {
    std::vector<double> x_ij, v_ij;
    double A, u, p, y, q, E;
};
template <int d>
Between between(const Numbers<d>& i, const Numbers<d>& j) {
    const auto x_ij = i.x - j.x, v_ij = i.v - j.v;
    const auto q = [](const Numbers<d>& a) { return member<MomentumPerCharge, double, d>(a)[0]; };
    return {{x_ij.begin(), x_ij.end()},
            {v_ij.begin(), v_ij.end()},
            j.A - i.A,
            j.u - i.u,
            j.p - i.p,
            j.y - i.y,
            q(j) - q(i),
            j.E - i.E};
}

enum class Along {
    nothing,  ///< none of those below
    positive,
    apart,      ///< x_ij
    friction,   ///< - v_ij
    approach,   ///< - v_ij . x_ij
    recession,  ///< v_ij . x_ij
    more_A,     ///< A_j - A_i; and so on
    more_u,
    more_q,
    more_E,
    uphill_A,  ///< (A_j - A_i) x_ji; and so on
    uphill_u,
    uphill_p,
    uphill_y
};
inline constexpr std::array all_directions{
    Along::positive, Along::apart,    Along::friction, Along::approach, Along::recession,
    Along::more_A,   Along::more_u,   Along::more_q,   Along::more_E,   Along::uphill_A,
    Along::uphill_u, Along::uphill_p, Along::uphill_y};

inline std::vector<double> times(double factor, std::vector<double> vector) {
    for (double& component : vector) component *= factor;
    return vector;
}
/// The direction: a number, or a vector.
inline std::vector<double> direction(Along along, const Between& pair) {
    double stretch = 0;
    for (std::size_t a = 0; a < pair.x_ij.size(); ++a) stretch += pair.x_ij[a] * pair.v_ij[a];
    switch (along) {
        case Along::nothing:
            return {};
        case Along::positive:
            return {1};
        case Along::apart:
            return pair.x_ij;
        case Along::friction:
            return times(-1, pair.v_ij);
        case Along::approach:
            return {-stretch};
        case Along::recession:
            return {stretch};
        case Along::more_A:
            return {pair.A};
        case Along::more_u:
            return {pair.u};
        case Along::more_q:
            return {pair.q};
        case Along::more_E:
            return {pair.E};
        case Along::uphill_A:
            return times(-pair.A, pair.x_ij);
        case Along::uphill_u:
            return times(-pair.u, pair.x_ij);
        case Along::uphill_p:
            return times(-pair.p, pair.x_ij);
        case Along::uphill_y:
            return times(-pair.y, pair.x_ij);
    }
    return {};
}

}  // namespace sph::tested
