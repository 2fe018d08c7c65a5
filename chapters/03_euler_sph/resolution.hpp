#pragma once
#include <algorithm>
#include <cmath>

#include "chapters/01_kernel_interpolation/interpolation.hpp"
#include "chapters/03_euler_sph/energy.hpp"
#include "chapters/03_euler_sph/forces.hpp"
#include "common/core/motion.hpp"
#include "common/core/unstable.hpp"

/// How a gas resolves itself: where density and smoothing lengths come from, and which pressure force and
/// heating are consistent with that. A resolution is a small type that a gas (gas.hpp) is made with.
namespace sph {

/// h = h_over_dx (m/rho)^(1/d)   (Monaghan 2005, 4.2, where it is called sigma); with `floor` > 0, h =
/// h_over_dx (m/(floor + rho))^(1/d), which stays finite where the density vanishes   (4.5).
/// h_over_dx > 0 [-], floor >= 0 in the unit of rho.
struct HRule {
    double h_over_dx = 1.2, floor = 0;
    double h(double m, double rho, int d) const { return h_over_dx * std::pow(m / (floor + rho), 1.0 / d); }
    double dh_drho(double h, double rho, int d) const { return -h / (d * (floor + rho)); }
};

/// What particles carry an amount of, and what that is by volume. A fluid that is counted by something else
/// than mass (chapter 8: entropy, baryons) names its columns, and the effects read and write those.
struct OfMass {
    using Amount = Mass;
    using PerVolume = Density;
    template <class Effect>
    using Counted = Effect;
};

/// One h for all, density summed   (2.9), the force (3.8).
template <class K, class Of = OfMass>
struct FixedH {
    using Kernel = K;
    using Counts = Of;
    using Columns = List<>;
    using Force = typename Of::template Counted<PressureForce<>>;
    using Heats = CompressionHeating<>;

    double h;
    K kernel{};

    ConstantH<K> smoothing() const { return {h, kernel}; }
    void evolve(Motion&, auto&) const {}
    void start(auto&) const {}
    template <class P, class N>
    void resolve(P& particles, N& neighbours) const {
        neighbours.find(particles.x, smoothing().reach());
        sum_over_neighbours(particles, neighbours, smoothing(),
                            Effects{typename Of::template Counted<SummedDensity>{}});
    }
};

/// One h for all, density by the continuity equation of Phi, with the force that belongs to it (5.26-5.36).
template <class K, class Phi>
struct ContinuityH {
    using Kernel = K;
    using Counts = OfMass;
    using Columns = List<DensityRate>;
    using Force = PressureForce<Phi>;
    using Heats = CompressionHeating<Phi>;

    double h;
    K kernel{};

    ConstantH<K> smoothing() const { return {h, kernel}; }
    void evolve(Motion& motion, auto& particles) const { motion.evolve<Density, DensityRate>(particles); }
    void start(auto&) const {}
    template <class P, class N>
    void resolve(P& particles, N& neighbours) const {
        neighbours.find(particles.x, smoothing().reach());
    }
    /// d rho/dt, for which Phi may need the pressure.
    auto rates() const { return Effects{Continuity<Phi>{}}; }
};

/// Each particle its own h by an HRule, solved together with the density   (4.2, 4.3), and the forces that
/// follow from the Lagrangian   (5.8, 5.13).
template <class K, class Of = OfMass>
class ConsistentH {
  public:
    using Kernel = K;
    using Counts = Of;
    using Columns = List<SmoothingLength, GradH, DensitySlope>;
    using Force = typename Of::template Counted<GradHForce>;
    using Heats = GradHHeating;

    /// `close`: the relative change of h at which the iteration ends; what is left is its square. The default
    /// is for gases that conserve energy through h alone.
    explicit ConsistentH(HRule h_rule, double close = 1e-12, K kernel = K{})
        : rule{h_rule}, kernel_{kernel}, close_{close} {}
    HRule rule;

    BothH<K> smoothing() const { return {kernel_}; }
    void evolve(Motion&, auto&) const {}
    /// h by the rule, from the densities that the particles begin with.
    template <class P>
    void start(P& p) const {
        for (std::size_t i = 0; i < p.size(); ++i) p.h[i] = rule.h(amount(p)[i], per_volume(p)[i], P::d);
    }

    /// Solves h_i = h(rho_i), rho_i = sum_j m_j W_ij(h_i) by Newton's method from the h of before, and leaves
    /// neighbours that serve the forces too. Throws Unstable if it does not converge.
    /// Cost: a search and, with a guess good to 1e-3, three or four passes.
    template <class P, class N>
    void resolve(P& particles, N& neighbours);

  private:
    static constexpr int most_iterations = 60;
    static constexpr double slack = 1.1;  // room to grow before the neighbours must be found again

    template <class P>
    static auto& amount(P& p) {
        return member<typename Of::Amount, Column, K::dimension>(p);
    }
    template <class P>
    static auto& per_volume(P& p) {
        return member<typename Of::PerVolume, Column, K::dimension>(p);
    }
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

    K kernel_;
    double close_;
    Column reach_, last_, low_, high_;  // where to look for neighbours; brackets of each h
};

/// One Newton step of f(h) = h - h(rho(h)), f' = Omega, in brackets: f < 0 below the solution, f > 0 above.
/// Where Newton would leave them (among random particles Omega may be 0 or negative) the bracket is halved,
/// or h changed by a half where one side is still open. Returns the largest relative change.
template <class K, class Of>
template <class P>
double ConsistentH<K, Of>::newton_step(P& p) {
    const Column& m = amount(p);
    Column& rho = per_volume(p);
    double largest = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double wanted = rule.h(m[i], rho[i], P::d), f = p.h[i] - wanted;
        p.Omega[i] = 1 - rule.dh_drho(wanted, rho[i], P::d) * p.drho_dh[i];
        (f < 0 ? low_ : high_)[i] = p.h[i];
        double h = p.h[i] - f / p.Omega[i];
        if (!(h >= low_[i] && h <= high_[i] && h > p.h[i] / 1.5 && h < 1.5 * p.h[i])) {
            const bool closed = low_[i] > 0 && high_[i] < std::numeric_limits<double>::infinity();
            h = closed ? std::sqrt(low_[i] * high_[i]) : f < 0 ? 1.5 * p.h[i] : p.h[i] / 1.5;
        }
        largest = std::max(largest, std::abs(h / p.h[i] - 1));
        rho[i] += p.drho_dh[i] * (h - p.h[i]);  // that of the new h, to second order
        p.h[i] = h;
    }
    return largest;
}

template <class K, class Of>
template <class P, class N>
void ConsistentH<K, Of>::resolve(P& p, N& neighbours) {
    const double support = kernel_.support;
    const auto reaches_far_enough = [&] {
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (reach_[i] < support * p.h[i]) return false;
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
            for (std::size_t i = 0; i < p.size(); ++i) reach_[i] = slack * support * p.h[i];
            neighbours.find(p.x, reach_, Support::symmetric);
        }
        sum_over_neighbours(p, neighbours, OwnH<K>{kernel_},
                            Effects{typename Of::template Counted<SummedDensity>{},
                                    typename Of::template Counted<DensitySlope>{}});
        change = newton_step(p);
        if (change < close_ && reaches_far_enough()) return;
    }
    throw Unstable{0, Unstable::no_particle, "the relative change of h in the last of 60 iterations", change};
}

/// The same h, but the terms of its variation left out: the force (3.8) with both kernels. Momentum is
/// conserved, energy is not.
template <class K, class Of = OfMass>
struct WithoutOmega : ConsistentH<K, Of> {
    using ConsistentH<K, Of>::ConsistentH;
    using Force = typename Of::template Counted<PressureForce<>>;
    using Heats = CompressionHeating<>;
};

/// The usual approach (section 4): h from the density of the step before, the mean of both h in each pair
/// (Chen 2017, 60). Nothing is solved, and what the forces conserve is momentum only.
template <class K>
struct AveragedH {
    using Kernel = K;
    using Counts = OfMass;
    using Columns = List<SmoothingLength>;
    using Force = PressureForce<>;
    using Heats = CompressionHeating<>;

    explicit AveragedH(HRule h_rule, K kernel = K{}) : rule{h_rule}, kernel_{kernel} {}
    HRule rule;

    MeanH<K> smoothing() const { return {kernel_}; }
    void evolve(Motion&, auto&) const {}
    template <class P>
    void start(P& p) const {
        for (std::size_t i = 0; i < p.size(); ++i) p.h[i] = rule.h(p.m[i], p.rho[i], P::d);
    }
    template <class P, class N>
    void resolve(P& p, N& neighbours) {
        reach_.resize(p.size());
        double largest = 0;
        for (const double h : p.h) largest = std::max(largest, h);
        for (std::size_t i = 0; i < p.size(); ++i) reach_[i] = kernel_.support * (p.h[i] + largest) / 2;
        neighbours.find(p.x, reach_);
        sum_over_neighbours(p, neighbours, smoothing(), Effects{SummedDensity{}});
        start(p);
    }

  private:
    K kernel_;
    Column reach_;
};

}  // namespace sph
