#pragma once
#include <Eigen/LU>

#include "chapters/03_euler_sph/scenes/star.hpp"

/// The star at rest, and what linear oscillations about it look like.
namespace sph {

/// d a_i/d x_j of a gas in one dimension, by central differences.
/// Cost: two evaluations of the rates a particle.
template <class G>
Eigen::MatrixXd jacobian(G& gas) {
    auto& p = gas.particles;
    const auto n = static_cast<Eigen::Index>(p.size());
    const auto accelerations = [&] {
        gas.rates(0);
        return Eigen::VectorXd{Eigen::Map<const Eigen::VectorXd>(p.dv_dt[0].data(), n)};
    };
    Eigen::MatrixXd J(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
        double& x = p.x[0][static_cast<std::size_t>(j)];
        // Large enough for ten digits of the difference, small enough for its own error of that order.
        const double start = x,
                     shift = 1e-4 * p.m[static_cast<std::size_t>(j)] / p.rho[static_cast<std::size_t>(j)];
        x = start + shift;
        const Eigen::VectorXd above = accelerations();
        x = start - shift;
        J.col(j) = (above - accelerations()) / (2 * shift);
        x = start;
    }
    return J;
}

namespace star_detail {

inline double largest_force(const auto& p) {
    double largest = 0;
    for (const double a : p.dv_dt[0]) largest = std::max(largest, std::abs(a));
    return largest;
}

}  // namespace star_detail

/// Brings the star to rest by Newton's method. A step moves no two neighbours more than 0.4 of their distance
/// together. Returns the Jacobian at rest.
template <class G>
Eigen::MatrixXd relax(G& gas) {
    constexpr int most_steps = 30;
    auto& p = gas.particles;
    const auto n = static_cast<Eigen::Index>(p.size());
    double before = std::numeric_limits<double>::infinity();
    for (int step = 0; step < most_steps; ++step) {
        Eigen::MatrixXd J = jacobian(gas);
        gas.rates(0);
        const double force = star_detail::largest_force(p);
        // Newton doubles the digits until rounding is reached.
        if (force < 1e-14 || (force < 1e-11 && force > before / 2)) return J;
        before = force;
        const Eigen::VectorXd shift =
            J.partialPivLu().solve(Eigen::Map<const Eigen::VectorXd>(p.dv_dt[0].data(), n));
        double part = 1;
        for (std::size_t i = 0; i + 1 < p.size(); ++i) {
            const auto k = static_cast<Eigen::Index>(i);
            const double gap = p.x[0][i + 1] - p.x[0][i], closing = std::abs(shift[k + 1] - shift[k]);
            if (part * closing > 0.4 * gap) part = 0.4 * gap / closing;
        }
        for (std::size_t i = 0; i < p.size(); ++i) p.x[0][i] -= part * shift[static_cast<Eigen::Index>(i)];
        require_physical(p, 0, List<Position>{});
    }
    throw Unstable{0, Unstable::no_particle, "the star at rest: largest force", before};
}

}  // namespace sph
