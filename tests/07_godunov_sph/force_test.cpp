// The force between two particles, seen from either, in one to three dimensions.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "chapters/07_godunov_sph/godunov_force.hpp"

using namespace sph;

namespace {

/// What the force reads of a particle: T is a number (i) or a tile (j).
template <class T, int d>
struct Seen {
    T m, rho, p, c_s, h;
    Vec<T, d> v, drho_dx, dp_dx;
    Vec<Vec<T, d>, d> dv_dx;
};
template <int d>
using One = Seen<double, d>;

template <int d>
Seen<Tile, d> eight(const One<d>& one) {
    Seen<Tile, d> all{one.m, one.rho, one.p, one.c_s, one.h, {}, {}, {}, {}};
    for (std::size_t a = 0; a < d; ++a) {
        all.v[a] = one.v[a], all.drho_dx[a] = one.drho_dx[a], all.dp_dx[a] = one.dp_dx[a];
        for (std::size_t b = 0; b < d; ++b) all.dv_dx[a][b] = one.dv_dx[a][b];
    }
    return all;
}
template <int d>
One<d> some(std::mt19937_64& random) {
    std::uniform_real_distribution<double> positive{0.5, 2}, any{-1, 1};
    One<d> one{positive(random), positive(random), positive(random), 1, positive(random), {}, {}, {}, {}};
    one.c_s = std::sqrt(1.4 * one.p / one.rho);
    for (std::size_t a = 0; a < d; ++a) {
        one.v[a] = 0.2 * any(random), one.drho_dx[a] = any(random), one.dp_dx[a] = any(random);
        for (std::size_t b = 0; b < d; ++b) one.dv_dx[a][b] = any(random);
    }
    return one;
}
template <int d>
struct Apart {
    Vec<Tile, d> x_ij;
    Tile r;
};
template <int d>
struct Sum {
    Vec<Tile, d> dv_dt{};
    Tile du_dt{};
};
template <class Force, int d>
Sum<d> seen_by(const Force& force, const One<d>& i, const One<d>& j, const Vector<d>& x_ij) {
    Apart<d> pair;
    for (std::size_t a = 0; a < d; ++a) pair.x_ij[a] = x_ij[a];
    pair.r = std::sqrt(dot(x_ij, x_ij));
    Sum<d> sum;
    force.add(i, eight<d>(j), pair, sum);
    return sum;
}

/// What i gets, j loses: momentum, and energy m (u + v . a) of both.
template <int d, class Sides, class Volumes, template <int> class Kernel>
void check() {
    using K = Kernel<d>;
    std::mt19937_64 random{d};
    std::uniform_real_distribution<double> any{-1, 1};
    const RiemannForce<Sides, Volumes, HllcRiemann, K> force{{}, {}, {}, {0.05, 1.4, K::bend, K::reach2}};
    double momentum = 0, energy = 0, largest = 0;
    for (int k = 0; k < 200; ++k) {
        const One<d> i = some<d>(random), j = some<d>(random);
        Vector<d> x_ij{};
        for (double& component : x_ij) component = any(random);
        const Sum<d> on_i = seen_by(force, i, j, x_ij), on_j = seen_by(force, j, i, -1.0 * x_ij);
        double work = i.m * on_i.du_dt[0] + j.m * on_j.du_dt[0];
        for (std::size_t a = 0; a < d; ++a) {
            const double of_i = i.m * on_i.dv_dt[a][0], of_j = j.m * on_j.dv_dt[a][0];
            momentum = std::max(momentum, std::abs(of_i + of_j)), largest = std::max(largest, std::abs(of_i));
            work += i.v[a] * of_i + j.v[a] * of_j;
        }
        energy = std::max(energy, std::abs(work));
    }
    CHECK(momentum < 1e-13 * largest);
    CHECK(energy < 1e-13 * largest);
    CHECK(largest > 0.1);
}
/// What stands between two particles, seen from either: the same area, and places that differ in sign.
template <int d, class Volumes, template <int> class Kernel>
void check_face() {
    std::mt19937_64 random{10 + d};
    std::uniform_real_distribution<double> any{-1, 1};
    double area = 0, place = 0, largest = 0, largest_place = 0;
    for (int k = 0; k < 200; ++k) {
        const One<d> i = some<d>(random), j = some<d>(random);
        Vector<d> x_ij{};
        for (double& component : x_ij) component = any(random);
        const double r = std::sqrt(dot(x_ij, x_ij));
        Vec<Tile, d> n, back;
        for (std::size_t a = 0; a < d; ++a) n[a] = x_ij[a] / r, back[a] = -x_ij[a] / r;
        const Between to_i = Volumes{}.face(i, eight<d>(j), n, Tile{r}, Kernel<d>{});
        const Between to_j = Volumes{}.face(j, eight<d>(i), back, Tile{r}, Kernel<d>{});
        area = std::max(area, std::abs(to_i.area[0] - to_j.area[0]));
        place = std::max(place, std::abs(to_i.s[0] + to_j.s[0]));
        largest = std::max(largest, std::abs(to_i.area[0]));
        largest_place = std::max(largest_place, std::abs(to_i.s[0]));
    }
    CHECK(area < 1e-13 * largest);
    CHECK(place < 1e-13 * largest_place);
    CHECK(largest_place > 0.01);
}
template <int d>
using Gaussians = ConvolvedGaussian<d>;

}  // namespace

TEST_CASE("a pair's force and heat conserve momentum and energy, whatever stands on its sides") {
    // Measured: 2e-15 of the largest force. Fails for a slope, a limiter or an area that i and j see
    // otherwise
    // (|V_i| for both in a threshold: 1e-3).
    check<1, PaperConstraint, CubicVolume, Gaussians>();
    check<2, PaperConstraint, LinearVolume, Gaussians>();
    check<1, VanLeer, GeometricVolume, ConvolvedQuadratic>();
    check<2, ThirdOrder, GeometricVolume, ConvolvedQuadratic>();
    check<3, ThirdOrder, GeometricVolume, ConvolvedQuadratic>();
    check<3, ConstantSides, CubicVolume, ConvolvedQuadratic>();
    check<2, ThirdOrder, CubicVolume, Gaussians>();
    check<3, ThirdOrder, CubicVolume, Gaussians>();
}

TEST_CASE("both particles see the same area between them, and compare their states at the same place") {
    // Measured: 2e-16 of the largest. Fails for h_i in both halves, and for the slope of i alone in V.
    check_face<1, LinearVolume, Gaussians>();
    check_face<1, CubicVolume, ConvolvedQuadratic>();
    check_face<2, CubicVolume, Gaussians>();
    check_face<3, CubicVolume, Gaussians>();
    check_face<2, GeometricVolume, Gaussians>();
    check_face<3, GeometricVolume, ConvolvedQuadratic>();
}

TEST_CASE("half a step across the line changes a pressure by what is compressed there") {
    // Exactly. Fails for a divergence along the line, a sign, and where `order` does not switch it off.
    One<2> i{1, 1, 1, std::sqrt(1.4), 1, {}, {}, {}, {}}, j = i;
    const Vec<Tile, 2> along_x{Tile{1.0}, Tile{0.0}};
    StepOfSides step{0.1, 1.4, 0.25, 3};
    const auto pressure = [&](const StepOfSides& of) {
        const TwoSides sides = ThirdOrder{}.meet(i, eight<2>(j), along_x, Tile{1.0}, Tile{0.0}, of);
        CHECK(sides.left.p[0] == sides.right.p[0]);
        return sides.right.p[0];
    };
    i.dv_dx[0][0] = j.dv_dx[0][0] = 0.3;  // along the line: sound brings that
    i.dv_dx[1][1] = j.dv_dx[1][1] = -0.5;
    CHECK(pressure(step) == Approx(1 + 0.5 * 1.4 * 0.1 * 0.5).epsilon(1e-14));
    step.order = 0;
    CHECK(pressure(step) == 1);
    i.dv_dx[1][1] = j.dv_dx[1][1] = 0, i.dv_dx[0][1] = j.dv_dx[0][1] = 1;  // a shear
    step.order = 1;
    CHECK(pressure(step) == 1);
}

TEST_CASE("the quintic is the quadratic spline convolved with itself, on a line") {
    // Measured: 4e-7, of the quadrature. Fails for another spline, or for h of another width.
    using K = ConvolvedQuadratic<1>;
    constexpr double step = 1e-3;
    for (const double r : {0.0, 0.4, 1.0, 1.7, 2.6}) {
        double sum = 0;
        for (double x = -3; x < 5; x += step)
            sum += step * K::W(std::abs(x), 1.0) * K::W(std::abs(x - r), 1.0);
        CHECK(K::wide_W(Tile{r}, 1.0)[0] == Approx(sum).margin(2e-6));
    }
}
