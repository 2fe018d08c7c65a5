#include "common/core/pass.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "tests/common/core/all_pairs.hpp"
#include "tests/common/core/test_kernel.hpp"

using namespace sph;

namespace {

using All = List<Position, Velocity, Mass, Density, Pressure, Acceleration, SmoothingLength>;

template <int d>
ParticlesOf<d, All> random_particles(std::size_t n, const Box<d>& box, std::uint64_t seed) {
    std::mt19937_64 bits{seed};
    const auto number = [&] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
    ParticlesOf<d, All> particles{n};
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t a = 0; a < d; ++a) {
            particles.x[a][i] = box.low[a] + (box.high[a] - box.low[a]) * number();
            particles.v[a][i] = 2 * number() - 1;
        }
        particles.m[i] = 0.5 + number();
        particles.p[i] = number();
        particles.h[i] = 0.15 + 0.1 * number();
    }
    return particles;
}

template <int d>
Box<d> unit_box(Face face) {
    Vector<d> low{}, high{};
    for (double& value : high) value = 1;
    return {low, high, face};
}

/// The largest difference between the engine's sums and sums over all pairs of images, relative to the
/// largest sum.
template <int d>
double worst_difference(const ParticlesOf<d, All>& p, const Box<d>& box, double h) {
    const auto all = all_pairs::sources<d>(&box, p.x, h);
    double worst = 0, largest = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        double rho = 0;
        Vector<d> dv_dt{};
        for (const auto& pair : all) {
            const std::size_t j = pair.owner;
            Vector<d> x_ij, v_ij;
            for (std::size_t a = 0; a < d; ++a) {
                x_ij[a] = p.x[a][i] - pair.x[a];
                v_ij[a] = p.v[a][i] - pair.sign[a] * p.v[a][j];
            }
            const double s = test::Bump::deficit(dot(x_ij, x_ij), h);
            rho += p.m[j] * s * s;
            dv_dt -= (p.m[j] * (p.p[i] + p.p[j]) * s * (-4 / (h * h))) * x_ij;
            dv_dt -= (2 * p.m[j] * s * s) * v_ij;
        }
        const double rho_error = std::abs(rho - p.rho[i]);
        worst = std::max(worst, rho_error);
        largest = std::max(largest, rho);
        for (std::size_t a = 0; a < d; ++a) {
            // The spring acts on the position itself, not on an image.
            worst = std::max(worst, std::abs(dv_dt[a] - 3 * p.x[a][i] - p.dv_dt[a][i]));
            largest = std::max(largest, std::abs(dv_dt[a]));
        }
    }
    return worst / largest;
}

template <int d, class Boundary>
void run(ParticlesOf<d, All>& particles, Neighbours<d, Boundary>& neighbours, double h,
         Keep keep = Keep::list) {
    neighbours.find(particles.x, h, Support::gather, keep);
    sum_over_neighbours(
        particles, neighbours, test::Constant{h},
        Effects{test::SummedDensity{}, test::PressureForce{}, test::Friction{2}, test::Spring{3}});
}

template <int d>
void check_sums() {
    for (const Face face : {Face::free, Face::periodic, Face::mirror}) {
        const Box<d> box = unit_box<d>(face);
        for (const double h : {0.2, 0.5, 1.4}) {  // 1.4: images of images
            auto particles = random_particles<d>(d == 3 ? 150 : 80, box, 7);
            Neighbours<d, Box<d>> neighbours{box};
            run<d>(particles, neighbours, h);
            CHECK(worst_difference<d>(particles, box, h) < 2e-14);  // measured: 9e-16
        }
    }
}

}  // namespace

TEST_CASE("a pass sums what all pairs sum, with vectors that mirrors reflect") {
    // Fails if a sign is not reflected, a lane of a tile is in the wrong place, the padding of the last tile
    // counts, a second effect overwrites the first one's column, or a force without pairs is lost.
    check_sums<1>();
    check_sums<2>();
    check_sums<3>();
}

TEST_CASE("results are bitwise the same for one thread and two, with a list and without") {
    const Box<2> box = unit_box<2>(Face::periodic);
    const auto initial = random_particles<2>(3000, box, 8);
    auto reference = initial;
    Neighbours<2, Box<2>> one{box, 1}, two{box, 2};
    run<2>(reference, one, 0.07);
    for (auto* neighbours : {&one, &two}) {
        for (const Keep keep : {Keep::list, Keep::nothing}) {
            auto again = initial;
            run<2>(again, *neighbours, 0.07, keep);
            CHECK(again.rho == reference.rho);
            CHECK(again.dv_dt == reference.dv_dt);
        }
    }
}

TEST_CASE("forces between pairs cancel: momentum is conserved to rounding") {
    // Fails if the support is not symmetric (some j would see i unseen), or if a pair is left out on one
    // side.
    const Box<2> box = unit_box<2>(Face::periodic);
    auto particles = random_particles<2>(500, box, 9);
    Neighbours<2, Box<2>> neighbours{box};
    neighbours.find(particles.x, particles.h, Support::symmetric);
    sum_over_neighbours(particles, neighbours, test::Mean{},
                        Effects{test::PressureForce{}, test::Friction{}});
    double total = 0, size = 0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        total += particles.m[i] * particles.dv_dt[0][i];
        size += std::abs(particles.m[i] * particles.dv_dt[0][i]);
    }
    CHECK(std::abs(total) < 1e-14 * size);  // measured: 1e-16
}

namespace {

/// The largest |v_ij| among neighbours, and the mean of x_ij x_ij^T: a maximum and a tensor.
struct FastestNeighbour {
    static constexpr std::string_view name = "fastest neighbour";
    static constexpr bool maximum = true;
    template <class T, int>
    struct In {
        T fastest{};
    };
};
struct Shape {
    static constexpr std::string_view name = "shape";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> shape{};
    };
};
struct Trace {
    static constexpr std::string_view name = "trace";
    template <class T, int>
    struct In {
        T trace{};
    };
};
struct ShapeSum {
    using ReadsJ = List<Mass>;
    using Adds = List<Shape>;
    void add(const auto&, const auto& j, const auto& pair, auto& sum) const {
        for (std::size_t a = 0; a < sum.shape.size(); ++a)
            sum.shape[a] += ((pair.W > 0).select(j.m, 0.0) * pair.x_ij[a]) * pair.x_ij;
    }
};
struct Measure {
    using Reads = List<Velocity>;
    using Adds = List<FastestNeighbour>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const auto v_ij = i.v - j.v;
        // A lane that is only padding has W = 0, and the particle itself v_ij = 0.
        sum.fastest = sum.fastest.max((pair.W > 0).select(dot(v_ij, v_ij).sqrt(), 0.0));
    }
};

/// Builds on a sum that is not stored.
struct ShapeTrace {
    using Uses = List<ShapeSum>;
    using Writes = List<Trace>;
    void finish(const auto&, const auto& sum, auto& out) const {
        out.trace = 0;
        for (std::size_t a = 0; a < sum.shape.size(); ++a) out.trace += sum.shape[a][a];
    }
};

}  // namespace

TEST_CASE("maxima, tensors, and results made of sums that are not stored") {
    const std::size_t n = 40;
    Particles<2, Position, Velocity, Mass, FastestNeighbour, Trace> particles{n};
    const auto random = random_particles<2>(n, unit_box<2>(Face::free), 10);
    particles.x = random.x;
    particles.v = random.v;
    particles.m.assign(n, 1);
    Neighbours<2> neighbours;
    const double h = 0.3;
    neighbours.find(particles.x, h);
    sum_over_neighbours(particles, neighbours, test::Constant{h}, Effects{Measure{}, ShapeTrace{}});
    for (std::size_t i = 0; i < n; ++i) {
        double fastest = 0, trace = 0;
        for (std::size_t j = 0; j < n; ++j) {
            const double x = particles.x[0][i] - particles.x[0][j], y = particles.x[1][i] - particles.x[1][j];
            if (x * x + y * y < h * h) {
                fastest = std::max(fastest, std::hypot(particles.v[0][i] - particles.v[0][j],
                                                       particles.v[1][i] - particles.v[1][j]));
                trace += x * x + y * y;
            }
        }
        CHECK(particles.trace[i] == Approx(trace).epsilon(1e-13));
        CHECK(particles.fastest[i] == Approx(fastest).epsilon(1e-14));
    }
}

TEST_CASE("sums that several effects use are made once") {
    // Fails if a used sum is added once for each user, or stored although it is not listed.
    using Both = decltype(Effects{ShapeTrace{}, ShapeSum{}});
    STATIC_REQUIRE(Both::pairwise() == 1);
    STATIC_REQUIRE(std::is_same_v<Both::Used, List<>>);
    using One = decltype(Effects{ShapeTrace{}});
    STATIC_REQUIRE(std::is_same_v<One::Used, List<ShapeSum>>);
    STATIC_REQUIRE(std::is_same_v<One::Stored, List<Trace>>);
    STATIC_REQUIRE(std::is_same_v<One::Summed, List<Shape>>);
    Particles<1, Position, Mass, Shape, Trace> particles{2};
    particles.x[0] = {0, 0.5};
    particles.m = {1, 1};
    Neighbours<1> neighbours;
    neighbours.find(particles.x, 1);
    sum_over_neighbours(particles, neighbours, test::Constant{1}, Effects{ShapeTrace{}, ShapeSum{}});
    CHECK(particles.shape[0][0] == Column{0.25, 0.25});
    CHECK(particles.trace == Column{0.25, 0.25});
}

TEST_CASE("nothing to sum: no particles, and one alone") {
    for (const std::size_t n : {std::size_t{0}, std::size_t{1}}) {
        ParticlesOf<3, All> particles{n};
        for (std::size_t i = 0; i < n; ++i) particles.m[i] = 2;
        Neighbours<3> neighbours;
        run<3>(particles, neighbours, 0.1);
        CHECK(neighbours.pairs() == n);
        if (n == 1) CHECK(particles.rho[0] == 2);
    }
}
