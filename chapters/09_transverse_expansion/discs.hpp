#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "chapters/01_kernel_interpolation/kernel.hpp"
#include "common/core/particles.hpp"

/// Where particles begin in a disc: places, and the area that each stands for.
namespace sph {

struct Disc {
    Columns<2> x;
    Column area;  ///< their sum is pi R^2
    void add(double r, double angle, double a) {
        x[0].push_back(r * std::cos(angle)), x[1].push_back(r * std::sin(angle)), area.push_back(a);
    }
};

/// The n points of the hexagonal lattice that are nearest to its point at the origin, n >= 7, R > 0: equal
/// areas, a jagged edge.
inline Disc hexagonal_disc(std::size_t n, double R) {
    const double a = std::sqrt(2 / std::sqrt(3.0) * pi * R * R / static_cast<double>(n)),
                 row = a * std::sqrt(3.0) / 2;
    const int most = static_cast<int>(1.2 * R / row) + 2;
    std::vector<std::array<double, 3>> points;
    for (int j = -most; j <= most; ++j) {
        for (int i = -2 * most; i <= 2 * most; ++i) {
            const double X = a * (i + 0.5 * std::abs(j % 2)), Y = row * j;
            points.push_back({X * X + Y * Y, std::atan2(Y, X), 0});
        }
    }
    // Points of one distance by their angles: the same choice on every machine.
    std::sort(points.begin(), points.end(), [a](const auto& p, const auto& q) {
        return std::abs(p[0] - q[0]) > 1e-9 * a * a ? p[0] < q[0] : p[1] < q[1];
    });
    Disc disc;
    for (std::size_t k = 0; k < n; ++k)
        disc.add(std::sqrt(points[k][0]), points[k][1], pi * R * R / static_cast<double>(n));
    return disc;
}

/// A point, and K rings of 6 k points at equal distances around it, 1 + 3 K (K + 1) in all, as many as come
/// nearest to n; each stands for its share of its ring.
inline Disc ring_disc(std::size_t n, double R) {
    const int K = std::max(1, static_cast<int>(std::lround(std::sqrt(static_cast<double>(n) / 3) - 0.5)));
    const double dr = R / (K + 0.5);
    Disc disc;
    disc.add(0, 0, pi * dr * dr / 4);
    for (int k = 1; k <= K; ++k) {
        for (int j = 0; j < 6 * k; ++j)
            disc.add(k * dr, 2 * pi * j / (6 * k), 2 * pi * k * dr * dr / (6 * k));
    }
    return disc;
}

/// Vogel's spiral: point k at k golden angles and at the radius inside which so many points have their place.
/// spacing(r) > 0: their distances at r, up to a factor that n decides. Wherever it changes slowly, cells are
/// round: the golden angle keeps neighbours apart at every radius.
inline Disc spiral_disc(std::size_t n, double R, const std::function<double(double r)>& spacing) {
    const double golden = pi * (3 - std::sqrt(5.0));
    constexpr std::size_t steps = 100000;
    const double dr = R / steps;
    Column inside(steps + 1, 0.0);  // points within r, up to the factor
    for (std::size_t k = 0; k < steps; ++k) {
        const double r = dr * (static_cast<double>(k) + 0.5);
        inside[k + 1] = inside[k] + 2 * pi * r * dr / (spacing(r) * spacing(r));
    }
    const auto radius = [&](double points) {
        const double wanted = points / static_cast<double>(n) * inside.back();
        const auto above = std::upper_bound(inside.begin() + 1, inside.end() - 1, wanted);
        const auto k = static_cast<std::size_t>(above - inside.begin());
        return dr * (static_cast<double>(k) - (inside[k] - wanted) / (inside[k] - inside[k - 1]));
    };
    // [spiral]
    Disc disc;
    for (std::size_t k = 0; k < n; ++k) {
        const auto place = static_cast<double>(k);
        const double inner = radius(place), outer = radius(place + 1);
        disc.add(radius(place + 0.5), golden * place, pi * (outer * outer - inner * inner));
    }
    // [end]
    return disc;
}

/// 1 inside, and towards the edge of a disc of radius R proportional to the square root of the distance, as
/// chapter 8's slab has it: from half the radius on, and an eighth at the edge.
inline double graded_spacing(double r, double R) {
    constexpr double zone = 0.5, least = 1.0 / 8;
    return std::sqrt(std::min(1.0, (1 - r / R) / zone + least * least));
}

}  // namespace sph
