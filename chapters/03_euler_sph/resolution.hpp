#pragma once
#include <algorithm>
#include <cmath>

#include "chapters/01_kernel_interpolation/interpolation.hpp"
#include "chapters/03_euler_sph/energy.hpp"
#include "chapters/03_euler_sph/pressure_force.hpp"
#include "common/core/equations.hpp"

/// How a gas resolves itself: where density and smoothing lengths come from, and which pressure force and
/// heating are consistent with that. A resolution is a small type that a Gas (gas.hpp) is made with.
namespace sph {

/// h = sigma (m/rho)^(1/d)   (Monaghan 2005, 4.2); with `floor` > 0, h = sigma (m/(floor + rho))^(1/d), which
/// stays finite where the density vanishes   (4.5). sigma > 0 [-], floor >= 0 in the unit of rho.
struct HRule {
    double sigma = 1.2, floor = 0;
    double h(double m, double rho, int d) const { return sigma * std::pow(m / (floor + rho), 1.0 / d); }
    double dh_drho(double h, double rho, int d) const { return -h / (d * (floor + rho)); }
};

/// One h for all, density summed   (2.9), the force (3.8).
template <class K>
struct FixedH {
    using Kernel = K;
    using Columns = List<>;
    using Force = PressureForce<>;
    using Heats = CompressionHeating<>;
    using Evolves = Equations<>;

    double h;

    ConstantH<K> smoothing() const { return {h}; }
    template <class P, class N>
    void resolve(P& particles, N& neighbours) const {
        neighbours.find(particles.x, smoothing().reach());
        sum_over_neighbours(particles, neighbours, smoothing(), Effects{SummedDensity{}});
    }
};

/// One h for all, density by the continuity equation of Phi, with the force that belongs to it (5.26-5.36).
template <class K, class Phi>
struct ContinuityH {
    using Kernel = K;
    using Columns = List<DensityRate>;
    using Force = PressureForce<Phi>;
    using Heats = CompressionHeating<Phi>;
    using Evolves = Equations<Evolve<Density, DensityRate>>;

    double h;

    ConstantH<K> smoothing() const { return {h}; }
    template <class P, class N>
    void resolve(P& particles, N& neighbours) const {
        neighbours.find(particles.x, smoothing().reach());
    }
    /// d rho/dt, for which Phi may need the pressure.
    auto rates() const { return Effects{Continuity<Phi>{}}; }
};

/// Each particle its own h by an HRule, solved together with the density   (4.2, 4.3), and the forces that
/// follow from the Lagrangian   (5.8, 5.13).
template <class K>
class ConsistentH {
  public:
    using Kernel = K;
    using Columns = List<SmoothingLength, GradH, DensitySlope>;
    using Force = GradHForce;
    using Heats = GradHHeating;
    using Evolves = Equations<>;

    /// `close`: the relative change of h at which the iteration ends; what is left is its square. The default
    /// is for gases that conserve energy through h alone.
    explicit ConsistentH(HRule h_rule, double close = 1e-12) : rule{h_rule}, close_{close} {}
    HRule rule;

    BothH<K> smoothing() const { return {}; }

    /// Solves h_i = h(rho_i), rho_i = sum_j m_j W_ij(h_i) by Newton's method from the h of before, and leaves
    /// neighbours that serve the forces too. Throws Unstable if it does not converge.
    /// Cost: a search and, with a guess good to 1e-3, three passes.
    template <class P, class N>
    void resolve(P& particles, N& neighbours);

  private:
    static constexpr int most_iterations = 60;
    static constexpr double slack = 1.1;  // room to grow before the neighbours must be found again

    /// Goes on as from the h before the last to the last: with equal time steps this saves a pass.
    template <class P>
    void guess(P& p) {
        if (last_.size() != p.size()) last_ = p.h;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double h = p.h[i], ratio = h / last_[i];
            if (std::abs(ratio - 1) < 0.1) p.h[i] = h * ratio;
            last_[i] = h;
        }
    }
    template <class P>
    double newton_step(P& particles);

    double close_;
    Column reach_, last_, low_, high_;  // where to look for neighbours; brackets of each h
};

/// One Newton step of f(h) = h - h(rho(h)), f' = Omega, in brackets: f < 0 below the solution, f > 0 above.
/// Where Newton would leave them (among random particles Omega may be 0 or negative) the bracket is halved,
/// or h changed by a half where one side is still open. Returns the largest relative change.
template <class K>
template <class P>
double ConsistentH<K>::newton_step(P& p) {
    double largest = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double wanted = rule.h(p.m[i], p.rho[i], P::d), f = p.h[i] - wanted;
        p.Omega[i] = 1 - rule.dh_drho(wanted, p.rho[i], P::d) * p.drho_dh[i];
        (f < 0 ? low_ : high_)[i] = p.h[i];
        double h = p.h[i] - f / p.Omega[i];
        if (!(h >= low_[i] && h <= high_[i] && h > p.h[i] / 1.5 && h < 1.5 * p.h[i])) {
            const bool closed = low_[i] > 0 && high_[i] < std::numeric_limits<double>::infinity();
            h = closed ? std::sqrt(low_[i] * high_[i]) : f < 0 ? 1.5 * p.h[i] : p.h[i] / 1.5;
        }
        largest = std::max(largest, std::abs(h / p.h[i] - 1));
        p.rho[i] += p.drho_dh[i] * (h - p.h[i]);  // that of the new h, to second order
        p.h[i] = h;
    }
    return largest;
}

template <class K>
template <class P, class N>
void ConsistentH<K>::resolve(P& p, N& neighbours) {
    const auto reaches_far_enough = [&] {
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (reach_[i] < K::support * p.h[i]) return false;
        }
        return true;
    };
    guess(p);
    low_.assign(p.size(), 0);
    high_.assign(p.size(), std::numeric_limits<double>::infinity());
    double change = 0;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
        if (iteration == 0 || !reaches_far_enough()) {
            reach_.resize(p.size());
            for (std::size_t i = 0; i < p.size(); ++i) reach_[i] = slack * K::support * p.h[i];
            neighbours.find(p.x, reach_, Support::symmetric);
        }
        sum_over_neighbours(p, neighbours, OwnH<K>{}, Effects{SummedDensity{}, DensitySlope{}});
        change = newton_step(p);
        if (change < close_ && reaches_far_enough()) return;
    }
    throw Unstable{0, Unstable::no_particle, "the relative change of h in the last of 60 iterations", change};
}

/// The same h, but the terms of its variation left out: the force (3.8) with both kernels. Momentum is
/// conserved, energy is not.
template <class K>
struct WithoutOmega : ConsistentH<K> {
    using ConsistentH<K>::ConsistentH;
    using Force = PressureForce<>;
    using Heats = CompressionHeating<>;
};

/// The usual approach (section 4): h from the density of the step before, the mean of both h in each pair
/// (Chen 2017, 60). Nothing is solved, and what the forces conserve is momentum only.
template <class K>
struct AveragedH {
    using Kernel = K;
    using Columns = List<SmoothingLength>;
    using Force = PressureForce<>;
    using Heats = CompressionHeating<>;
    using Evolves = Equations<>;

    explicit AveragedH(HRule h_rule) : rule{h_rule} {}
    HRule rule;

    MeanH<K> smoothing() const { return {}; }
    template <class P, class N>
    void resolve(P& p, N& neighbours) {
        reach_.resize(p.size());
        double largest = 0;
        for (const double h : p.h) largest = std::max(largest, h);
        for (std::size_t i = 0; i < p.size(); ++i) reach_[i] = K::support * (p.h[i] + largest) / 2;
        neighbours.find(p.x, reach_);
        sum_over_neighbours(p, neighbours, smoothing(), Effects{SummedDensity{}});
        for (std::size_t i = 0; i < p.size(); ++i) p.h[i] = rule.h(p.m[i], p.rho[i], P::d);
    }

  private:
    Column reach_;
};

}  // namespace sph
