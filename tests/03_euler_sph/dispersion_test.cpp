// Sound on a lattice: the corrected dispersion relation, its limits, and simulations.
#include <catch2/catch.hpp>

#include "chapters/01_kernel_interpolation/kernels.hpp"
#include "chapters/03_euler_sph/dispersion.hpp"
#include "chapters/03_euler_sph/scenes/wave.hpp"

using namespace sph;
using namespace sph::euler;

TEST_CASE("the dispersion relation has the digits of an independent computation") {
    // Cubic spline, h = 1.2, gamma = 5/3, from the numerical Jacobian of the equations; 14 digits.
    struct Row {
        int k;
        double fixed_h, variable_h;
    };
    for (const Row& row :
         {Row{1, 0.010219341219947, 0.0096850146001891}, Row{5, 0.24258440694178, 0.26586732908037},
          Row{16, 1.4672953870948, 2.6268060210778}, Row{29, 1.42571269067, 1.5620769378996}}) {
        const Dispersion d = dispersion<CubicSpline<1>>(1.2, 5.0 / 3, pi * row.k / 32);
        INFO("k = " << row.k << "/32 pi");
        CHECK(d.fixed_h == Approx(row.fixed_h).epsilon(2e-13));
        CHECK(d.variable_h == Approx(row.variable_h).epsilon(2e-13));
    }
}

// Values of an independent sum; fails with the kernel's W left out of dW/dh.
TEST_CASE("the slope of density with h on an even line, of the cubic spline and the Gaussian") {
    CHECK(std::abs(lattice_slope<CubicSpline<1>>(1.0)) < 1e-14);  // all aliases fall on zeros
    CHECK(lattice_slope<CubicSpline<1>>(1.2) == Approx(0.0205).margin(5e-5));
    CHECK(lattice_slope<CubicSpline<1>>(1.5) == Approx(-0.0164).margin(5e-5));
    CHECK(1 + lattice_slope<Gaussian<1>>(0.8) == Approx(0.95453).margin(5e-6));
    // Its first alias (5.10) at h = dx.
    CHECK(lattice_slope<Gaussian<1>>(1.0) == Approx(-square(2 * pi) * std::exp(-square(pi))).epsilon(1e-3));
}

TEST_CASE("the printed relation, with the second derivative of W by h in (6.4), is wrong") {
    // Psi as printed: dx sum (1 - cos kx) d2W/dh2, instead of d2W/dx2.
    constexpr double h = 1.2, gamma = 5.0 / 3, k = pi / 8;
    double rho = 0, Phi = 0, Psi = 0;
    for (int c = -3; c <= 3; ++c) {
        const double x = c, r = std::abs(x);
        const double W = CubicSpline<1>::W(r, h), W_x = x * CubicSpline<1>::F(r, h);
        const double W_xx = CubicSpline<1>::d2W_dr2(r, h);
        rho += W;
        Phi += std::sin(k * x) * W_x;
        Psi += (1 - std::cos(k * x)) * (2 * W + 4 * x * W_x + x * x * W_xx) / (h * h);
    }
    const double printed = ((gamma - 2) * square(Phi / rho) + 2 * Psi / rho) / gamma;
    const double right = dispersion<CubicSpline<1>>(h, gamma, k).fixed_h;
    CHECK(std::abs(printed / right - 1) > 0.5);  // measured: -2.3
}

TEST_CASE("long waves: 1 + 2 b h^2 k^2 (n - gamma)/gamma with n = 1, 2, 3") {
    // Gaussian, b = 1/4; h = 2 spacings, where the lattice's own error is below 1e-15.
    constexpr double h = 2, k = 0.02;
    for (const double gamma : {1.0, 1.4, 2.0, 3.0}) {
        const Dispersion d = dispersion<Gaussian<1>>(h, gamma, k);
        const auto limit = [&](int n) { return 1 + h * h * k * k / 2 * (n - gamma) / gamma; };
        // What is left is of order (hk)^4 = 2.6e-6.
        CHECK(d.fixed_h / (k * k) == Approx(limit(1)).epsilon(3e-6));
        CHECK(d.without_omega / (k * k) == Approx(limit(2)).epsilon(3e-6));
        CHECK(d.variable_h / (k * k) == Approx(limit(3)).epsilon(3e-6));
    }
}

TEST_CASE("simulated waves have the frequency of the formula") {
    // Measured: within 2e-8 for all; the bound is that of the text.
    for (const std::string resolution : {"fixed-h", "without-omega", "consistent-h"}) {
        for (const int waves : {1, 8, 16, 31}) {
            WaveScene scene;
            scene.waves = waves;
            scene.gamma = 5.0 / 3;
            scene.courant = 0.1;
            const double omega2 =
                measured_omega2(scene, {resolution, "cubic", 1.2}) * square(scene.spacing());
            const Dispersion d = dispersion<CubicSpline<1>>(1.2, scene.gamma, 2 * pi * waves / 64);
            const double formula = resolution == "fixed-h"         ? d.fixed_h
                                   : resolution == "without-omega" ? d.without_omega
                                                                   : d.variable_h;
            INFO(resolution << ", " << waves << " waves");
            CHECK(omega2 == Approx(formula).epsilon(1e-7));
        }
    }
}

TEST_CASE("a standing wave: the best scheme is of fourth order, one h does not converge") {
    const auto error = [](std::size_t n, const GasMethod& scheme) {
        WaveScene wave;
        wave.n = n;
        return run_wave(wave, scheme).error;
    };
    const GasMethod best{"consistent-h", "super-gaussian", 1.35};
    const double e16 = error(16, best), e64 = error(64, best);
    CHECK(e64 < 1e-4);  // measured 6.5e-5
    CHECK(e64 > 1e-5);
    CHECK(std::log2(e16 / e64) / 2 > 3.8);  // measured 4.36
    CHECK(std::log2(e16 / e64) / 2 < 5);
    const GasMethod cubic{"consistent-h", "cubic", 1.2};
    const double order = std::log2(error(16, cubic) / error(64, cubic)) / 2;
    CHECK(order > 1.6);  // measured 1.83
    CHECK(order < 2.2);
    const GasMethod one_h{"fixed-h", "cubic", 1.2};
    CHECK(error(128, one_h) > error(32, one_h));                               // 0.156, 0.141
    CHECK(error(64, {"without-omega", "cubic", 1.2}) > 3 * error(64, cubic));  // 0.057, 0.018
}
