// A kernel chosen when the program runs is the kernel of that name.
#include "chapters/01_kernel_interpolation/any_kernel.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <limits>
#include <stdexcept>

#include "chapters/01_kernel_interpolation/kernels.hpp"

using namespace sph;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// The largest difference of two tiles over `scale`.
double difference(const Tile& a, const Tile& b, double scale) {
    return (a - b).abs().maxCoeff() / scale;
}

/// The largest relative difference of W, F and W'' between AnyKernel and the type, up to beyond the support.
template <class K>
double worst_difference(K) {
    const AnyKernel<K::dimension> any{K::name};
    CHECK(any.name == K::name);
    CHECK(any.support == K::support);
    double worst = 0;
    for (const double h : {0.9, 0.013}) {
        for (int n = 0; n < 40; ++n) {
            std::array<double, tile_width> distance{};
            for (std::size_t lane = 0; lane < tile_width; ++lane)
                distance[lane] = K::support * h * 1.05 * (n * 8 + double(lane)) / 320;
            const Tile r = Tile::load(distance.data()), h_ij = h;
            worst = std::max({worst, difference(any.W(r, h), K::W(r, h), K::W(0.0, h)),
                              difference(any.W(r, h_ij), K::W(r, h), K::W(0.0, h)),
                              difference(any.F(r, h), K::F(r, h), -K::F(0.0, h)),
                              difference(any.F(r, h_ij), K::F(r, h), -K::F(0.0, h)),
                              difference(any.d2W_dr2(r, h), K::d2W_dr2(r, h), -K::d2W_dr2(0.0, h))});
        }
    }
    return worst;
}

template <int d>
void check_all() {
    std::vector<std::string> names;
    const auto check = [&](const auto& kernel) {
        INFO(kernel.name << " in " << d << "D");
        names.emplace_back(kernel.name);
        CHECK(worst_difference(kernel) <= 4 * eps);  // measured 1.4 eps: fused products
    };
    for_each_kernel<d>(check);
    check(QuadraticSpline<d>{});
    auto known = any_kernel_names();
    std::sort(names.begin(), names.end());
    std::sort(known.begin(), known.end());
    CHECK(names == known);
}

}  // namespace

TEST_CASE("a kernel chosen by name gives what its type gives, in every dimension") {
    // Fails if two numbers are exchanged, for the sigma of another dimension, or for a power of h too many.
    check_all<1>();
    check_all<2>();
    check_all<3>();
}

TEST_CASE("a kernel that nobody knows is refused by name") {
    CHECK_THROWS_WITH(AnyKernel<2>{"cubik"}, "no such kernel: cubik");
    CHECK_THROWS_AS(AnyKernel<1>{""}, std::invalid_argument);
}
