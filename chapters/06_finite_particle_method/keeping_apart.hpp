#pragma once
#include <cmath>
#include <limits>

#include "chapters/05_tensile_instability/cures.hpp"
#include "chapters/06_finite_particle_method/burgers_line.hpp"

/// What is to keep particles apart that follow u: a force, a shift, or even particles in their place.
namespace sph {

/// du_i/dt = sum_j D [(r_0/r)^4 - (r_0/r)^2] x_ij/r^2 where r < r_0, else 0   (Chen 2017, 66, with p_1 = 4
/// and p_2 = 2; Monaghan 1994, who keeps particles from walls by it). Antisymmetric and along x_ij. Below
/// r_0/100 it is taken as if r were that.
struct NearRepulsion {
    // [repulsion]
    double D = 1;    ///< >= 0 [velocity^2]
    double q_0 = 1;  ///< r_0/h, > 0, below the kernel's support
    using Adds = List<Acceleration>;
    void add(const auto&, const auto&, const auto& pair, auto& sum) const {
        const auto r_0 = q_0 * pair.h;
        const Tile r = pair.r.max(0.01 * r_0), q2 = square((r_0 / r).max(1.0));
        sum.dv_dt += (D * (q2 * q2 - q2) / (r * r)) * pair.x_ij;
    }
    // [end]
};

/// One effect, summed over particles on a line and their images.
template <class Effect, class Result>
class LineSum {
    struct Make {
        Images<1> images;
        void operator()(const Columns<1>& x, double reach, std::vector<Ghost<1>>& ghosts) const {
            if (images) images(x, reach, ghosts);
        }
    };
    struct Nothing {
        template <class Row>
        void operator()(Row&, const Ghost<1>&) const {}
    };

  public:
    /// `h` > 0 [length], the same for all; `volume`: that of every particle [length].
    LineSum(Effect effect, AnyKernel<1> kernel, double h, double volume, Images<1> images)
        : effect_{effect},
          smoothing_{h, kernel},
          volume_{volume},
          neighbours_{{Make{std::move(images)}, Nothing{}}} {}

    /// Of particles at x.
    const Column& at(const Columns<1>& x) {
        points_.resize(x[0].size());
        points_.x = x;
        std::fill(points_.V.begin(), points_.V.end(), volume_);
        neighbours_.find(points_.x, smoothing_.reach());
        sum_over_neighbours(points_, neighbours_, smoothing_, Effects{effect_});
        return member<Result, Column, 1>(points_)[0];
    }

  private:
    Effect effect_;
    ConstantH<AnyKernel<1>> smoothing_;
    double volume_;
    Particles<1, Position, Volume, Result> points_;
    Neighbours<1, GhostsOf<Make, Nothing>> neighbours_;
};

/// Shifting: each moves with u and down the gradient of how dense particles are,
///     w_i = u_i - s U h g_i,   g_i = sum_j V [1 + R (W_ij/W(dx))^4] grad_i W_ij   (Lind et al. 2012),
/// with chapter 5's s = 1/2 and R = 0.2; V = dx, the volume at the start. As w is not u, (w - u) u_x keeps
/// the equation of u.
class Shifted final : public Frame {
  public:
    /// `dx` > 0: the spacing at the start; U > 0: the largest |u| there.
    Shifted(AnyKernel<1> kernel, double h, double dx, double U, Images<1> images)
        : rate_{strength * U * h},
          disorder_{{repulsion, kernel.W(Tile(dx), h)[0]}, kernel, h, dx, std::move(images)} {}
    void velocities(BurgersParticles& p, const Rows<1>&) const override {
        const Column& g = disorder_.at(p.x);
        for (std::size_t i = 0; i < p.size(); ++i) p.w[0][i] = p.v[0][i] - rate_ * g[i];
    }

  private:
    static constexpr double strength = 0.5, repulsion = 0.2;
    double rate_;
    mutable LineSum<DisorderGradient, DisorderGradient> disorder_;
};

/// Particles that move with u, which near pairs change: a force that Burgers' equation does not have.
class Repelled final : public Frame {
  public:
    /// `dx` > 0: the spacing at the start, r_0; U > 0: the largest |u| there, D = U^2.
    Repelled(AnyKernel<1> kernel, double h, double dx, double U, Images<1> images)
        : force_{{U * U, dx / h}, kernel, h, dx, std::move(images)} {}
    void velocities(BurgersParticles& p, const Rows<1>&) const override { p.w[0] = p.v[0]; }
    void add_forces(BurgersParticles& p) const override {
        const Column& force = force_.at(p.x);
        for (std::size_t i = 0; i < p.size(); ++i) p.dv_dt[0][i] += force[i];
    }

  private:
    mutable LineSum<NearRepulsion, Acceleration> force_;
};

/// Monaghan's M4': even, of support 2, its sum over an even line is 1, and it carries the first and second
/// moments over exactly (Monaghan 1985; Chen 2017 has splines only).
inline double m4_prime(double q) {
    q = std::abs(q);
    if (q < 1) return 1 - q * q * (2.5 - 1.5 * q);
    if (q < 2) return 0.5 * (2 - q) * (2 - q) * (1 - q);
    return 0;
}

/// The places (i + 1/2)/n.
inline Columns<1> even_places(std::size_t n) {
    Columns<1> x;
    for (std::size_t i = 0; i < n; ++i)
        x[0].push_back((static_cast<double>(i) + 0.5) / static_cast<double>(n));
    return x;
}

/// What particles have is shared out to even ones: a_p = sum_q a_q M4'((x_p - x_q)/dx), for the carried mass
/// and for a = u times the space of a particle (its part of the integral of u). Conserves both sums, but for
/// what passes the mirrors.
inline void remesh_by_sharing(BurgersParticles& p) {
    const std::size_t n = p.size();
    const double dx = 1 / static_cast<double>(n);
    Column mass(n, 0.0), momentum(n, 0.0);
    for (std::size_t q = 0; q < n; ++q) {
        const double u_space = p.v[0][q] * space_of(p.x[0], q);
        for (const bool image : {false, true}) {
            const double wall = p.x[0][q] < 0.5 ? 0 : 1, x = image ? 2 * wall - p.x[0][q] : p.x[0][q];
            const auto first = static_cast<long>(std::floor(x / dx - 0.5)) - 1;
            for (long k = std::max(first, 0L); k < std::min(first + 4, static_cast<long>(n)); ++k) {
                const auto at = static_cast<std::size_t>(k);
                const double weight = m4_prime((static_cast<double>(k) + 0.5) - x / dx);
                mass[at] += p.carried[q] * weight;
                momentum[at] += (image ? -u_space : u_space) * weight;
            }
        }
    }
    for (std::size_t i = 0; i < n; ++i) p.v[0][i] = momentum[i] / dx;
    p.carried = mass;
    p.x = even_places(n);
}

/// u and the carried mass by length are interpolated at even places by the fit of `estimates`.
inline void remesh_by_fit(BurgersParticles& p, Estimates<1>& estimates) {
    // [remesh]
    const std::size_t n = p.size();
    estimates.at_particles(p.x, p.m, p.h);
    const Columns<1> places = even_places(n);
    const Rows<1>& rows = estimates.at(places, p.h);
    Column u, carried_by_length(n), density;
    for (std::size_t i = 0; i < n; ++i) carried_by_length[i] = p.carried[i] / space_of(p.x[0], i);
    rows.apply(0, p.v[0], Parity::odd, u);
    rows.apply(0, carried_by_length, Parity::even, density);
    p.x = places, p.v[0] = u;
    for (std::size_t i = 0; i < n; ++i) p.carried[i] = density[i] / static_cast<double>(n);
    // [end]
}

}  // namespace sph
