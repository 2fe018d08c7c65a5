// How much two particles exchange: by the formulas of the text in plain numbers, for one pair.
#include <catch2/catch.hpp>
#include <cmath>

#include "chapters/08_landau_model/relativistic_dissipation.hpp"

using namespace sph;

namespace {

/// What the exchanges read of a particle; of T = Tile for the neighbour.
template <class T>
struct Gas {
    Vec<T, 1> v, q, dy_dx, dp_dx;
    T m, E, c_s, n_star, y, h_enthalpy, u, p, h;
};
Gas<double> gas(double v, double u, double p, double n_star) {
    const double lorentz = 1 / std::sqrt(1 - v * v), enthalpy = 1 + 5.0 / 3 * u;
    return {{{v}},
            {{enthalpy * lorentz * v}},
            {{0}},
            {{0}},
            0.3,
            enthalpy * lorentz - p / n_star,
            0.4,
            n_star,
            std::atanh(v),
            enthalpy,
            u,
            p,
            0.1};
}
Gas<Tile> tiles(const Gas<double>& g) {
    return {{{Tile{g.v[0]}}},
            {{Tile{g.q[0]}}},
            {{Tile{g.dy_dx[0]}}},
            {{Tile{g.dp_dx[0]}}},
            Tile{g.m},
            Tile{g.E},
            Tile{g.c_s},
            Tile{g.n_star},
            Tile{g.y},
            Tile{g.h_enthalpy},
            Tile{g.u},
            Tile{g.p},
            Tile{g.h}};
}
struct Pair {
    Vec<Tile, 1> x_ij{{Tile{-0.05}}};
    Tile r{0.05}, F{-30.0};
};
struct Sum {
    Vec<Tile, 1> dq_dt{{Tile{0.0}}};
    Tile dE_dt{0.0}, step_rate{0.0};
};
template <class Exchange>
Sum exchanged(const Exchange& exchange, const Gas<double>& i, const Gas<double>& j) {
    Sum sum;
    exchange.add(i, tiles(j), Pair{}, sum);
    return sum;
}
constexpr double r_F = 0.05 * -30.0;

}  // namespace

TEST_CASE("Chow and Monaghan's exchange has its size") {
    // Fails for another factor in the mean density or in the signals. They approach: i is left, and faster.
    const auto i = gas(0.6, 0.5, 0.4, 2.0), j = gas(-0.2, 0.3, 0.2, 3.0);
    const double w = (0.6 + 0.2) / (1 + 0.6 * 0.2), one = (0.4 + w) / (1 + 0.4 * w), v_sig = 2 * one + w;
    const double weight = 0.5 * 0.3 * v_sig / 2.5 * r_F;
    const Sum sum = exchanged(ChowMonaghan{}, i, j);
    CHECK(sum.dq_dt[0][0] == Approx(weight * (i.q[0] - j.q[0])).epsilon(1e-12));
    CHECK(sum.dE_dt[0] == Approx(weight * (i.E - j.E)).epsilon(1e-12));
    CHECK(exchanged(ChowMonaghan{}, j, i).dE_dt[0] == 0);  // they recede
}

TEST_CASE("the reconstructed exchange has its size, and limits the step by the lighter of two") {
    // Fails for another factor anywhere. Without slopes all of the jump in rapidity is exchanged.
    const auto i = gas(0.6, 0.5, 0.4, 2.0), j = gas(-0.2, 3.0, 0.2, 3.0);
    const auto plus = [](double v) { return (v + 0.4) / (1 + v * 0.4); };
    const double spread = plus(0.6) + plus(0.2), jump = -2 * std::sinh((i.y - j.y) / 2),
                 y = 0.5 * (i.y + j.y);
    const double enthalpy = 0.5 * (i.h_enthalpy + j.h_enthalpy), rate = 0.85 * 0.3 * spread / 2.5 * r_F;
    const Sum sum = exchanged(ReconstructedExchange{}, i, j);  // i is on the left: its n is -1
    CHECK(sum.dq_dt[0][0] == Approx(-rate * jump * enthalpy * std::cosh(y)).epsilon(1e-12));
    CHECK(sum.dE_dt[0] == Approx(-rate * jump * enthalpy * std::sinh(y)).epsilon(1e-12));
    CHECK(sum.step_rate[0] == Approx(-rate * enthalpy / i.h_enthalpy).epsilon(1e-12));
}

TEST_CASE("the reconstructed exchange is of the jump that both slopes leave") {
    // Fails for another mean of the speeds of sound or of the slopes, or for another trust in them.
    auto i = gas(0.6, 0.5, 0.4, 2.0), j = gas(-0.2, 3.0, 0.2, 3.0);
    i.dy_dx[0] = -12, j.dy_dx[0] = -8, j.c_s = 0.2;
    const double w = i.y - j.y, c = 0.3, slope = -9.6 * c * c / (c * c + w * w);  // -9.6 = 2 a b/(a + b)
    const double left = w + 0.05 * slope, y = 0.5 * (i.y + j.y);
    const double fastest = (0.6 + 0.4) / (1 + 0.6 * 0.4), slowest = (-0.2 - 0.2) / (1 + 0.2 * 0.2);
    const double rate = 0.85 * 0.3 * (fastest - slowest) / 2.5 * r_F;
    const double enthalpy = 0.5 * (i.h_enthalpy + j.h_enthalpy);
    const Sum sum = exchanged(ReconstructedExchange{}, i, j);
    CHECK(sum.dq_dt[0][0] == Approx(2 * rate * std::sinh(left / 2) * enthalpy * std::cosh(y)).epsilon(1e-12));
    CHECK(sum.dE_dt[0] == Approx(2 * rate * std::sinh(left / 2) * enthalpy * std::sinh(y)).epsilon(1e-12));
    CHECK(sum.step_rate[0] == Approx(-rate * left / w * enthalpy / i.h_enthalpy).epsilon(1e-12));
    // Slopes that explain more than the jump leave none.
    i.dy_dx[0] = j.dy_dx[0] = -1e4;
    CHECK(exchanged(ReconstructedExchange{}, i, j).dq_dt[0][0] == 0);
}

TEST_CASE("the conduction has its size, and its cap") {
    // Fails for another mean, another power of lorentz, or a cap of the faster sound.
    const auto i = gas(0.3, 0.5, 0.4, 2.0), j = gas(0.3, 0.3, 0.4 - 1e-6, 3.0);
    const double lorentz = 1 / std::sqrt(1 - 0.09);
    const double inertia = 0.5 * (2.0 * i.h_enthalpy + 3.0 * j.h_enthalpy) / lorentz;
    const double v_u = 2 * std::sqrt(1e-6 / inertia) / (lorentz * lorentz);
    const double weight = 0.3 * v_u * (0.5 - 0.3) / 2.5 * r_F;
    CHECK(exchanged(ContactConduction{}, i, j).dE_dt[0] == Approx(weight * lorentz).epsilon(1e-7));
    CHECK(exchanged(ContactConduction{}, i, j).dq_dt[0][0] == Approx(weight * lorentz * 0.3).epsilon(1e-7));
    const auto far = gas(0.3, 0.3, 0.1, 3.0);  // a large jump of pressure
    const double capped = 0.3 * 0.2 * 0.4 / (lorentz * lorentz) * (0.5 - 0.3) / 2.5 * r_F;
    CHECK(exchanged(ContactConduction{}, i, far).dE_dt[0] == Approx(capped * lorentz).epsilon(1e-12));
}
