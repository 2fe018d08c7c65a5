// The pieces: the kernel, each viscosity on one pair, switches, conduction.
#include <catch2/catch.hpp>
#include <cmath>

#include "chapters/01_kernel_interpolation/splines.hpp"
#include "chapters/04_artificial_viscosity/dissipative_gas.hpp"

using namespace sph;

namespace {

struct Side {
    Vec<double, 1> v_mid{}, x{};
    double rho = 1, c_s = 1, h = 1, u = 1, p = 1;
    Vec<Vec<double, 1>, 1> dv_dx{};
    Vec<double, 1> dp_dx{};
};
struct Other {
    Vec<Tile, 1> v_mid{};
    Tile rho = Tile(1.0), c_s = Tile(1.0), h = Tile(1.0), u = Tile(1.0), p = Tile(1.0);
    Vec<Vec<Tile, 1>, 1> dv_dx{};
    Vec<Tile, 1> dp_dx{};
};

/// i at 0 and j at distance r to the right, closing with speed w (> 0: they approach).
struct PairOf {
    Side i;
    Other j;
    SidedPair<1> pair;
    PairOf(double r, double w) {
        i.v_mid[0] = w;
        j.v_mid[0] = Tile(0.0);
        pair.x_ij[0] = Tile::Constant(-r);
        pair.r = Tile::Constant(r);
        pair.F_i = pair.F_j = Tile(-1.0);
        j.dv_dx[0][0] = Tile(0.0);
        j.dp_dx[0] = Tile(0.0);
    }
};

}  // namespace

TEST_CASE("the quadratic spline: normalised, its slope the derivative, a partition of unity at h = dx") {
    double one = 0, two = 0, three = 0;
    const int n = 20000;
    for (int k = 0; k < n; ++k) {
        const double r = 1.5 * (k + 0.5) / n, dr = 1.5 / n;
        one += 2 * QuadraticSpline<1>::W(r, 1.0) * dr;
        two += 2 * pi * r * QuadraticSpline<2>::W(r, 1.0) * dr;
        three += 4 * pi * r * r * QuadraticSpline<3>::W(r, 1.0) * dr;
    }
    CHECK(one == Approx(1).epsilon(1e-8));
    CHECK(two == Approx(1).epsilon(1e-8));
    CHECK(three == Approx(1).epsilon(1e-8));
    for (const double q : {0.1, 0.49, 0.7, 1.3}) {
        const double slope = (QuadraticSpline<1>::w(q + 1e-6) - QuadraticSpline<1>::w(q - 1e-6)) / 2e-6;
        CHECK(QuadraticSpline<1>::dw(q) == Approx(slope).epsilon(1e-8));
        const double curve = (QuadraticSpline<1>::dw(q + 1e-6) - QuadraticSpline<1>::dw(q - 1e-6)) / 2e-6;
        CHECK(QuadraticSpline<1>::d2w(q) == Approx(curve).epsilon(1e-8));
    }
    for (const double shift : {0.0, 0.2, 0.5}) {
        double sum = 0;
        for (int k = -3; k <= 3; ++k) sum += QuadraticSpline<1>::W(std::abs(k + shift), 1.0);
        CHECK(sum == Approx(1).epsilon(1e-14));
    }
}

TEST_CASE("viscosities: the printed values for one pair, none for particles that recede") {
    const PairOf near{0.5, 0.25}, apart{0.5, -0.25};
    // mu = -h w r/(r^2 + 0.01 h^2), Pi = -mu (alpha c - beta mu)/rho
    const double mu = 0.25 * 0.5 / (0.25 + 0.01);
    CHECK(AlphaBeta{}.pressure(near.i, near.j, near.pair)[0] == Approx(mu * (1 + 2 * mu)));
    CHECK(AlphaBeta{.beta = 0}.pressure(near.i, near.j, near.pair)[0] == Approx(mu));
    CHECK(SignalViscosity{}.pressure(near.i, near.j, near.pair)[0] == Approx(0.5 * 0.25 * (2 + 4 * 0.25)));
    CHECK(AlphaBeta{}.pressure(apart.i, apart.j, apart.pair)[0] == 0);
    CHECK(SignalViscosity{}.pressure(apart.i, apart.j, apart.pair)[0] == 0);
    // A particle and itself, and two at one place: finite.
    const PairOf same{0, 0.25};
    CHECK(SignalViscosity{}.pressure(same.i, same.j, same.pair)[0] == 0);
    CHECK(std::isfinite(ReconstructedViscosity{}.pressure(same.i, same.j, same.pair)[0]));
}

TEST_CASE("reconstruction takes out what both slopes explain, and trusts it less beyond the speed of sound") {
    PairOf pair{0.5, 0.25};
    pair.i.dv_dx[0][0] = -0.5;  // v falls by 0.25 over the distance: all of it
    pair.j.dv_dx[0][0] = Tile(-0.5);
    const double left = 0.25 - 0.25 / (1 + 0.25 * 0.25);
    CHECK(ReconstructedViscosity{}.pressure(pair.i, pair.j, pair.pair)[0] ==
          Approx(0.5 * left * (2 + 4 * left)));
    // Without slopes it is the signal viscosity, with half of them half is taken out (fails if `slopes` does
    // not multiply).
    const auto with = [&](double slopes) {
        return ReconstructedViscosity{{}, slopes}.pressure(pair.i, pair.j, pair.pair)[0];
    };
    CHECK(with(0) == SignalViscosity{}.pressure(pair.i, pair.j, pair.pair)[0]);
    const double half = 0.25 - 0.125 / (1 + 0.25 * 0.25);
    CHECK(with(0.5) == Approx(0.5 * half * (2 + 4 * half)));
    pair.j.dv_dx[0][0] = Tile(0.5);  // slopes of different signs: nothing
    CHECK(ReconstructedViscosity{}.pressure(pair.i, pair.j, pair.pair)[0] ==
          Approx(SignalViscosity{}.pressure(pair.i, pair.j, pair.pair)[0]));
    CHECK(common_slope(Tile(1.0), Tile(3.0))[0] == Approx(1.5));
    CHECK(common_slope(Tile(-1.0), Tile(3.0))[0] == 0);
}

TEST_CASE("conduction flows from hot to cold, and not where the pressure is even") {
    PairOf pair{0.5, 0};
    pair.i.u = 2;
    const Conduction<ContactSpeed> conduction;
    struct {
        Tile du_dt = Tile(0.0);
    } sum;
    struct : Other {
        Tile m = Tile(1.0);
    } j;
    j.dp_dx[0] = Tile(0.0);
    conduction.add(pair.i, j, pair.pair, sum);
    CHECK(sum.du_dt[0] == 0);
    j.p = Tile(0.98);
    conduction.add(pair.i, j, pair.pair, sum);
    CHECK(sum.du_dt[0] == Approx(-std::sqrt(0.02) * 0.5));  // m v_u (u_i - u_j)/rho r F
    sum.du_dt = Tile(0.0);
    j.p = Tile(0.5);  // capped at 0.2 c_s
    conduction.add(pair.i, j, pair.pair, sum);
    CHECK(sum.du_dt[0] == Approx(-0.2 * 0.5));
}

TEST_CASE("Morris and Monaghan's alpha rises in compression to 2 at most, and decays to alpha_0") {
    Particles<1, SmoothingLength, SoundSpeed, VelocityGradient, ViscosityAlpha> p{2};
    p.h = {1, 1};
    p.c_s = {1, 1};
    p.alpha = {0.1, 1.5};
    p.dv_dx[0][0] = {-100, 1};
    const MorrisMonaghan detector;
    detector.evolve(p, 1);
    CHECK(p.alpha[0] == Approx((0.1 * 0.2 + 200) / 100.2).epsilon(1e-6));
    CHECK(p.alpha[0] < 2);
    CHECK(p.alpha[1] == Approx(0.1 + 1.4 * std::exp(-0.2)));
}
