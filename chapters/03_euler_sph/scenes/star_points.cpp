#include <numbers>

#include "chapters/03_euler_sph/scenes/star.hpp"

namespace sph::euler {
namespace {

/// Mass of the star between x = sin(a) and sin(b): the integral of cos^(2/(gamma-1) + 1), which is smooth in
/// the angle also at the edge. Gauss-Legendre with eight nodes on each of four panels.
double mass_between(double a, double b, double gamma) {
    constexpr std::array node{0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
    constexpr std::array weight{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                0.1012285362903763};
    constexpr int panels = 4;
    double sum = 0;
    for (int panel = 0; panel < panels; ++panel) {
        const double half = (b - a) / (2 * panels), middle = a + (2 * panel + 1) * half;
        for (std::size_t k = 0; k < node.size(); ++k) {
            for (const double side : {-1.0, 1.0})
                sum += half * weight[k] *
                       std::pow(std::cos(middle + side * half * node[k]), 2 / (gamma - 1) + 1);
        }
    }
    return sum;
}

/// The angle below which the part `share` of the mass lies, by bisection.
double angle_of_mass(double share, double gamma) {
    constexpr double edge = std::numbers::pi / 2;
    const double wanted = (2 * share - 1) * mass_between(0, edge, gamma);
    double low = -edge, high = edge;
    for (int k = 0; k < 60; ++k) {
        const double middle = (low + high) / 2;
        (mass_between(0, middle, gamma) < wanted ? low : high) = middle;
    }
    return (low + high) / 2;
}

/// The angle of the point that lies at `share` (0..1) of the particles.
double angle_at(double share, const StarScene& scene) {
    if (scene.spacing == Spacing::masses) return angle_of_mass(share, scene.gamma);
    const double s = 2 * share - 1;
    if (scene.spacing == Spacing::even) return std::asin(s);
    return std::asin((s + std::sin(std::numbers::pi / 2 * s)) / 2);
}

}  // namespace

StarPoints star_points(const StarScene& scene) {
    StarPoints points;
    const auto n = static_cast<double>(scene.n);
    for (std::size_t i = 0; i < scene.n; ++i) {
        const auto place = static_cast<double>(i);
        const double low = angle_at(place / n, scene), high = angle_at((place + 1) / n, scene);
        points.x.push_back(std::sin(angle_at((place + 0.5) / n, scene)));
        points.m.push_back(mass_between(low, high, scene.gamma));
        points.width.push_back(std::sin(high) - std::sin(low));
    }
    return points;
}

}  // namespace sph::euler
