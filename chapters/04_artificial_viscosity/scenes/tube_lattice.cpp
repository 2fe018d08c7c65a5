#include "chapters/04_artificial_viscosity/scenes/tube_lattice.hpp"

#include <cmath>
#include <stdexcept>

namespace sph::shocks {
namespace {

constexpr std::size_t layer = 12;  // particles beyond either end: more than two supports

/// How many free particles one side has: those that waves reach, and ten in reserve.
std::size_t count(double length, double dx) {
    const double wanted = std::abs(length) / dx + 10;
    if (!(wanted < 1e7)) throw std::invalid_argument{"more than ten million particles on one side"};
    return static_cast<std::size_t>(wanted);
}

/// ln(1 + e^x) without overflow.
double softplus(double x) {
    return x > 0 ? x + std::log1p(std::exp(-x)) : std::log1p(std::exp(x));
}

}  // namespace

double right_share(double x, double d) {
    return x > 0 ? 1 / (1 + std::exp(-x / d)) : std::exp(x / d) / (1 + std::exp(x / d));
}

void smooth_positions(TubeLattice& lattice, const std::array<double, 2>& rho, double d) {
    if (!(rho[0] > 0 && rho[1] > 0)) throw std::invalid_argument{"a vacuum cannot be smoothed"};
    for (std::size_t i = 0; i < lattice.x.size(); ++i) {
        // The mass between x and 0 before, M, is rho_L x + (rho_R - rho_L) d ln(1 + e^(x/d)) after: Newton.
        const double mass = rho[lattice.side[i]] * lattice.x[i];
        double& x = lattice.x[i];
        for (int step = 0; step < 50; ++step) {
            const double excess = rho[0] * x + (rho[1] - rho[0]) * d * softplus(x / d) - mass;
            const double change = excess / (rho[0] + (rho[1] - rho[0]) * right_share(x, d));
            x -= change;
            if (std::abs(change) < 1e-14 * d) break;
        }
    }
}

TubeLattice lay_tube(const TubeScene& scene, const std::array<double, 2>& rho,
                     const std::array<double, 2>& ends) {
    TubeLattice lattice;
    const auto n = static_cast<double>(scene.n);
    const double left = scene.diaphragm - scene.window[0], right = scene.window[1] - scene.diaphragm;
    std::array<double, 2> spacing{};
    for (std::size_t side = 0; side < 2; ++side) {
        if (!(rho[side] > 0)) continue;
        lattice.m[side] =
            scene.equal_masses ? (rho[0] * left + rho[1] * right) / n : rho[side] * (left + right) / n;
        spacing[side] = lattice.m[side] / rho[side];
    }
    std::array<std::size_t, 2> size{};
    for (std::size_t side = 0; side < 2; ++side) {
        if (rho[side] > 0) size[side] = count(ends[side], spacing[side]);
    }
    /// The k-th particle of a side, counted from the middle.
    const auto add = [&](std::size_t side, std::size_t k) {
        lattice.x.push_back((side == 0 ? -1 : 1) * (static_cast<double>(k) + 0.5) * spacing[side]);
        lattice.side.push_back(side);
    };
    for (std::size_t k = size[0]; k-- > 0;) add(0, k);
    for (std::size_t k = 0; k < size[1]; ++k) add(1, k);
    lattice.free = lattice.x.size();
    std::mt19937_64 random{scene.seed};
    for (std::size_t i = 0; i < lattice.free; ++i)
        lattice.x[i] += scene.jitter * random_shift(random) * spacing[lattice.side[i]];
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        if (size[side] == 0) continue;
        const std::size_t begin = lattice.x.size();
        for (std::size_t k = 0; k < layer; ++k) add(side, size[side] + (side == 0 ? layer - 1 - k : k));
        lattice.layers.push_back({side == 0 ? "left layer" : "right layer", begin, lattice.x.size()});
    }
    return lattice;
}

}  // namespace sph::shocks
