// The Riemann problem of relativistic gas where plain formulas lose digits.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "common/exact/relativistic_riemann.hpp"

using exact::RelativisticRiemann;
using State = RelativisticRiemann::State;

namespace {

struct Known {
    std::string name;
    double gamma;
    State left, right;
    double p, rapidity, rho_left, rho_right;
};
/// Star states from the formulas of textbooks in arithmetic of 400 digits.
const std::vector<Known> table{{"strong blast",
                                4.0 / 3,
                                {1, 0, 1e6},
                                {1, 0, 0.0001},
                                335.05099220053713,
                                3.4646318939842409,
                                0.0024764706271181098,
                                66.990612313896869},
                               {"blast of another kind",
                                5.0 / 3,
                                {0.01, 0, 1e-06},
                                {100, 0, 1e4},
                                5.6606317209519163,
                                -3.6179661139071456,
                                0.48110268581317933,
                                1.1264682110576234},
                               {"cold gas on the right",
                                5.0 / 3,
                                {10, 0, 13.33},
                                {1, 0, 0},
                                1.4476826583823422,
                                0.89527757072004244,
                                2.6394043832565652,
                                5.0706367367264042},
                               {"streams at lorentz 20",
                                4.0 / 3,
                                {1, 0.998749217771909, 0.001},
                                {2, -0.998749217771909, 0.001},
                                745.49205289061203,
                                -0.17157932918707859,
                                97.944143882886412,
                                140.79456317448448},
                               {"streams at lorentz 1000",
                                5.0 / 3,
                                {1, 0.999999499999875, 1e-12},
                                {0.001, -0.999999499999875, 1},
                                2635337.4828502538,
                                -0.22925214605822828,
                                3145.6474930665672,
                                1.9878198062837516},
                               {"hot streams",
                                2.0,
                                {0.001, 0.9, 1e3},
                                {1, -0.9, 1e6},
                                600832.85593689918,
                                -1.7269386635827241,
                                0.024511886733774024,
                                0.77513408900454067},
                               {"receding",
                                5.0 / 3,
                                {1, -0.5, 1},
                                {1, 0.5, 1},
                                0.24970719557396355,
                                0,
                                0.43496932868853491,
                                0.43496932868853491},
                               {"receding, hot",
                                1.4,
                                {1, -0.9, 1e6},
                                {3, 0.95, 1e5},
                                8162.8707759996283,
                                0.69988483462816795,
                                0.032244765995082835,
                                0.50103284702780145},
                               {"nearly a vacuum",
                                5.0 / 3,
                                {1, -0.99, 1},
                                {1, 0.985, 1},
                                3.3556267478408946e-5,
                                -0.10199520817635292,
                                0.0020675888835751015,
                                0.0020675888835751015},
                               {"nearly isothermal",
                                1.001,
                                {1, 0, 10},
                                {1, 0, 1},
                                3.0704268136069204,
                                0.037300012863706486,
                                0.30740507920531767,
                                3.0662230724969371},
                               {"nearly isothermal, receding",
                                1.001,
                                {1, -0.6, 0.001},
                                {2, 0.1, 0.001},
                                3.0616269771285033e-12,
                                -0.25618334829476482,
                                3.1221791426298475e-9,
                                6.2443582852596949e-9},
                               {"pressures 1e-8 apart",
                                5.0 / 3,
                                {1, 0, 1.00000001},
                                {1, 0, 1},
                                1.000000005,
                                2.0701966565732311e-9,
                                0.99999999700000004,
                                1.000000003},
                               {"velocities 1e-8 apart",
                                1.4,
                                {3, 0, 1e-06},
                                {1, -1e-08, 1e-06},
                                1.0000075013226228e-6,
                                -3.6602567451008157e-9,
                                3.0000160742455378,
                                1.0000053580818459},
                               {"receding by 1e-8",
                                4.0 / 3,
                                {1, 0.49999999, 7},
                                {1, 0.5, 7},
                                6.9999998903203334,
                                0.54930613766738823,
                                0.99999998824860713,
                                0.99999998824860713},
                               {"boosted to lorentz 100",
                                5.0 / 3,
                                {10, 0.9999499987499375, 13.33},
                                {1, 0.9999499987499375, 1e-08},
                                1.4476826898622091,
                                6.1935699282297496,
                                2.6394044176928822,
                                5.0706365453780396},
                               {"cold streams, lorentz 2 and 100",
                                1.4,
                                {1, 0.9999499987499375, 0},
                                {5, 0.8660254037844386, 0},
                                37.442074460601729,
                                2.9302813135200829,
                                21.347156497132336,
                                58.163535045815311},
                               {"cold streams, one rounding apart",
                                4.0 / 3,
                                {1, 0.9999994999998751, 0},
                                {1, 0.999999499999875, 0},
                                3.5950692307537107e-21,
                                7.600902209627583,
                                7.0000000000000013,
                                7.0000000000000013},
                               {"dense and light",
                                5.0 / 3,
                                {1e40, 0, 1e10},
                                {1, 0, 1e-6},
                                1.0000000000049968e-6,
                                3.870539658920075e-15,
                                2.5118864315171135e+30,
                                1.0000000000029981},
                               {"heavy and light",
                                5.0 / 3,
                                {1e8, 0, 1},
                                {1e-08, -0.9, 1},
                                19.698085330019811,
                                -0.000362557707879615,
                                336703758.51992464,
                                5.327811871021238e-8},
                               {"cold as stone",
                                1.4,
                                {1, 1e-07, 1e-12},
                                {1, 0, 1e-13},
                                5.6824646635473314e-13,
                                5.5890526307369247e-7,
                                0.66783488741450266,
                                3.0040568486195677}};

}  // namespace

// Fails where a difference cancels: h - 1, e - e_K, 1 - v, v_L - v_R, F(p) - F(p_K), p - p_K.
TEST_CASE("relativistic riemann: every digit of strong, weak, hot, cold and fast problems") {
    for (const Known& known : table) {
        CAPTURE(known.name);
        const auto star = RelativisticRiemann{known.left, known.right, known.gamma}.star();
        CHECK(star.p == Approx(known.p).epsilon(1e-15));  // measured 2e-16
        CHECK(star.rapidity == Approx(known.rapidity).epsilon(1e-15));
        CHECK(star.rho_left == Approx(known.rho_left).epsilon(1e-15));
        CHECK(star.rho_right == Approx(known.rho_right).epsilon(1e-15));
        CHECK(star.v == Approx(std::tanh(known.rapidity)).epsilon(1e-15));
    }
    // Two streams of cold gas stop each other: u = W - 1, rho = rho_0 (gamma W + 1)/(gamma - 1).
    for (const double W : {1.0000000001, 2.0, 20.0, 1e3, 1e6}) {
        const double v = std::sqrt((W - 1) * (W + 1)) / W, gamma = 4.0 / 3;
        const long double slow = (1 - static_cast<long double>(v)) * (1 + static_cast<long double>(v));
        const double lorentz = static_cast<double>(1 / std::sqrt(slow));  // of the rounded v
        const auto star = RelativisticRiemann{{1, v, 0}, {1, -v, 0}, gamma}.star();
        CHECK(star.rapidity == 0);
        CHECK(star.rho_left == Approx((gamma * lorentz + 1) / (gamma - 1)).epsilon(2e-15));
        const double kinetic = static_cast<double>(v * v / slow) / (lorentz + 1);  // W - 1
        CHECK(star.u_right == Approx(kinetic).epsilon(2e-15));
        CHECK(star.p == Approx((gamma * lorentz + 1) * kinetic).epsilon(2e-15));
    }
}
