#pragma once
#include <cmath>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/core/vec.hpp"

/// Places of particles: even, jittered or random points of the periodic unit
/// box.
namespace sph {

enum class Arrangement { even, jittered, random };
/// The names that options accept, in the order of Arrangement.
inline const std::vector<std::string>& arrangement_names() {
    static const std::vector<std::string> names{"even", "jittered", "random"};
    return names;
}
/// Throws std::invalid_argument for a name that is none of arrangement_names().
inline Arrangement arrangement_named(const std::string& name) {
    for (const Arrangement one : {Arrangement::even, Arrangement::jittered, Arrangement::random}) {
        if (arrangement_names()[static_cast<std::size_t>(one)] == name) return one;
    }
    throw std::invalid_argument{"no such arrangement of particles: " + name};
}

/// Uniform numbers in [0, 1), the same on every machine (the distributions of the standard library are not).
class Uniform {
  public:
    explicit Uniform(std::uint64_t seed) : bits_{seed} {}
    double operator()() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }

  private:
    std::mt19937_64 bits_;
};

/// `per_side`^d points of the box [0, 1)^d: a square lattice (even), the lattice with each coordinate shifted
/// by a random amount within +-jitter spacings (jittered), or independent uniform points (random). `per_side`
/// >= 1, `jitter` >= 0 [spacings]. Deterministic for a given `seed`.
template <int d>
Columns<d> make_points(Arrangement arrangement, std::size_t per_side, double jitter, std::uint64_t seed) {
    Uniform uniform{seed};
    std::size_t n = 1;
    for (int axis = 0; axis < d; ++axis) n *= per_side;
    const double spacing = 1.0 / static_cast<double>(per_side);
    Columns<d> x;
    for (auto& column : x) column.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        std::size_t rest = i;
        for (std::size_t axis = 0; axis < d; ++axis) {
            double c = (static_cast<double>(rest % per_side) + 0.5) * spacing;
            if (arrangement == Arrangement::jittered) c += jitter * spacing * (2 * uniform() - 1);
            if (arrangement == Arrangement::random) c = uniform();
            x[axis][i] = c - std::floor(c);
            rest /= per_side;
        }
    }
    return x;
}

}  // namespace sph
