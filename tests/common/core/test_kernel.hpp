#pragma once
#include <cmath>

#include "common/core/pass.hpp"

/// A kernel and a smoothing for tests of the engine, which knows neither.
namespace test {

/// (1 - r^2/h^2)^2 for r < h: F = dW/dr / r = -4 (1 - r^2/h^2) / h^2. Not normalised.
struct Bump {
    template <class T, class H>
    static T deficit(const T& r2, const H& h) {
        if constexpr (std::is_arithmetic_v<T>) {
            return std::max(1 - r2 / (h * h), 0.0);
        } else {
            return (1 - r2 / (h * h)).max(0.0);
        }
    }
};

/// The same h for all.
struct Constant {
    double h;
    template <int d>
    struct Pair {
        sph::Vec<sph::Tile, d> x_ij;
        sph::Tile W, F;
    };
    template <int d>
    Pair<d> pair(const auto&, const auto&, const sph::Vec<sph::Tile, d>& x_ij) const {
        const sph::Tile s = Bump::deficit(dot(x_ij, x_ij), h);
        return {x_ij, s.square(), s * (-4 / (h * h))};
    }
};

/// The mean of both h.
struct Mean {
    using Reads = sph::List<sph::SmoothingLength>;
    template <int d>
    Constant::Pair<d> pair(const auto& i, const auto& j, const sph::Vec<sph::Tile, d>& x_ij) const {
        const sph::Tile h = 0.5 * (i.h + j.h);
        const sph::Tile s = Bump::deficit(dot(x_ij, x_ij), h);
        return {x_ij, s.square(), -4.0 * s / h.square()};
    }
};

struct SummedDensity {
    using ReadsJ = sph::List<sph::Mass>;
    using Adds = sph::List<sph::Density>;
    void add(const auto&, const auto& j, const auto& pair, auto& sum) const { sum.rho += j.m * pair.W; }
};
/// dv_i/dt = - sum_j m_j (p_i + p_j) x_ij F: antisymmetric where all masses are equal.
struct PressureForce {
    using Reads = sph::List<sph::Pressure>;
    using ReadsJ = sph::List<sph::Mass>;
    using Adds = sph::List<sph::Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.dv_dt -= (j.m * (i.p + j.p) * pair.F) * pair.x_ij;
    }
};
/// A second effect that adds to the same column: dv_i/dt += sum_j m_j (v_j - v_i) W.
struct Friction {
    double strength = 1;
    using Reads = sph::List<sph::Velocity>;
    using ReadsJ = sph::List<sph::Mass>;
    using Adds = sph::List<sph::Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.dv_dt -= (strength * j.m * pair.W) * (i.v - j.v);
    }
};
/// An effect without pairs: a force towards the origin.
struct Spring {
    double strength = 1;
    using ReadsI = sph::List<sph::Position>;
    using Writes = sph::List<sph::Acceleration>;
    void finish(const auto& i, const auto&, auto& out) const { out.dv_dt -= strength * i.x; }
};

}  // namespace test
