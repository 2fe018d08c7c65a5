#pragma once
#include <algorithm>
#include <cmath>

#include "chapters/06_finite_particle_method/burgers_line.hpp"

/// Particles that move to where they are needed, instead of where u carries them. All for a line from 0 to 1
/// with mirrors at its ends.
namespace sph {

/// What says where particles are needed.
struct Monitor {
    double power =
        0.25;  ///< of |u_xx|: a fourth, for a scheme whose error grows with the spacing's fourth power
    double share = 0.5;   ///< of the particles that follow the monitor; the others are spread evenly
    int smoothings = 32;  ///< how often it is averaged with weights 1/4, 1/2, 1/4: over four spacings
};

/// Equidistribution. Let M(x) > 0 say how dense particles should be. Their wanted places X_i share out the
/// integral of M,
///     int_0^X_i M dx = (i + 1/2)/N int_0^1 M dx,   M = 1 - share + share m / (mean of m),   m =
///     |u_xx|^power,
/// m smoothed over neighbours, and each particle goes there within the time tau: w_i = (X_i - x_i)/tau.
///
/// No step dt <= tau makes particles cross: x_i + dt w_i = (1 - dt/tau) x_i + (dt/tau) X_i is a mean of two
/// ordered lines.
class Equidistributing final : public Frame {
  public:
    /// `h_in_spaces`: smoothing length of a particle over its space, > 0; tau > 0 [time].
    Equidistributing(Monitor monitor, double h_in_spaces, double tau)
        : monitor_{monitor}, h_in_spaces_{h_in_spaces}, tau_{tau} {}

    void begin_step(BurgersParticles& p, double dt) override {
        // [frame]
        const double within = std::max(tau_, dt);
        const Column& wanted = wanted_places(p.x[0], p.v[0]);
        velocity_.resize(p.size());
        for (std::size_t i = 0; i < p.size(); ++i) velocity_[i] = (wanted[i] - p.x[0][i]) / within;
        // [end]
    }
    void velocities(BurgersParticles& p, const Rows<1>&) const override { p.w[0] = velocity_; }
    void smoothing_lengths(BurgersParticles& p) const override {
        for (std::size_t i = 0; i < p.size(); ++i) p.h[i] = h_in_spaces_ * space_of(p.x[0], i);
    }
    /// The places X of ordered x with values u.
    const Column& wanted_places(const Column& x, const Column& u);

  private:
    void measure(const Column& x, const Column& u);

    Monitor monitor_;
    double h_in_spaces_, tau_;
    Column velocity_, wanted_, m_;
};

/// m of each gap: the larger curvature of its two particles, to the power, smoothed.
inline void Equidistributing::measure(const Column& x, const Column& u) {
    const std::size_t n = x.size();
    const auto slope = [&](std::size_t k) {
        const double before = k == 0 ? -u[0] : u[k - 1], after = k == n ? -u[n - 1] : u[k];
        return (after - before) / gap(x, k);
    };
    m_.assign(n + 1, 0);
    for (std::size_t i = 0; i < n; ++i) {
        const double curvature = std::abs(slope(i + 1) - slope(i)) / space_of(x, i);
        m_[i] = std::max(m_[i], curvature), m_[i + 1] = curvature;
    }
    for (double& m : m_) m = std::pow(m, monitor_.power);
    for (int pass = 0; pass < monitor_.smoothings; ++pass) {
        double before = m_[0];
        for (std::size_t k = 0; k <= n; ++k) {
            const double now = m_[k], after = m_[std::min(k + 1, n)];
            m_[k] = 0.25 * before + 0.5 * now + 0.25 * after;
            before = now;
        }
    }
}

inline const Column& Equidistributing::wanted_places(const Column& x, const Column& u) {
    const std::size_t n = x.size();
    measure(x, u);
    // The part of a gap that lies between the ends.
    const auto inside = [&](std::size_t k) { return k == 0 || k == n ? 0.5 * gap(x, k) : gap(x, k); };
    double mean = 0;
    for (std::size_t k = 0; k <= n; ++k) mean += m_[k] * inside(k);
    for (double& m : m_) m = mean > 0 ? 1 - monitor_.share + monitor_.share * m / mean : 1;
    double whole = 0;
    for (std::size_t k = 0; k <= n; ++k) whole += m_[k] * inside(k);
    wanted_.resize(n);
    double sum = 0;
    std::size_t k = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(n) * whole;
        for (; k < n && sum + m_[k] * inside(k) < share; ++k) sum += m_[k] * inside(k);
        wanted_[i] = (k == 0 ? 0 : x[k - 1]) + (share - sum) / m_[k];
    }
    return wanted_;
}

}  // namespace sph
