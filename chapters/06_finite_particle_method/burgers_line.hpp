#pragma once
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "chapters/06_finite_particle_method/estimates.hpp"
#include "common/core/integrated.hpp"
#include "common/core/unstable.hpp"

/// Burgers' equation on a line of particles that stand still, move with u, or move as one likes:
///     u_t + u u_x = gamma u_xx     (Ye et al. 2019, 20)
///     dx_i/dt = w_i,   du_i/dt = gamma u_xx + (w_i - u_i) u_x.
namespace sph {

/// How u = 0 at the ends of a line is told to particles (Ye et al. 2019, section 4).
enum class Ends {
    frozen,  ///< a particle on either end, which neither moves nor changes its u; nothing beyond
    none,    ///< not at all
    free,    ///< further particles beyond the ends, which move like all others
    mirror   ///< images beyond the ends, with - u
};

/// Images in mirrors at low and high. A particle that stands in the mirror is its own image and gets none;
/// one that has passed it has its image inside.
inline Images<1> mirror_images(double low, double high) {
    return [low, high](const Columns<1>& x, double reach, std::vector<Ghost<1>>& images) {
        for (const double wall : {low, high}) {
            for (std::size_t i = 0; i < x[0].size(); ++i) {
                const double distance = std::abs(x[0][i] - wall);
                if (distance < reach && distance > 0)
                    images.push_back({static_cast<std::uint32_t>(i), {2 * wall - x[0][i]}, {-1}});
            }
        }
    };
}

/// The velocity w with which particles move, which need not be u.
struct FrameVelocity {
    static constexpr std::string_view name = "velocity of the frame";
    template <class T, int d>
    struct In {
        Vec<T, d> w{};
    };
};
/// The mass of the fluid that a particle carries, if u moves it. The equation of u does not ask for it.
struct CarriedMass {
    static constexpr std::string_view name = "carried mass";
    template <class T, int>
    struct In {
        T carried{};
    };
};
/// Mass is what the sums of the kernel weigh a particle with.
using BurgersParticles =
    Particles<1, Position, Velocity, Acceleration, Mass, CarriedMass, SmoothingLength, FrameVelocity>;

/// Distance between particle k - 1 and particle k of a line from 0 to 1, counted over the images behind its
/// ends: k = 0 .. n.
inline double gap(const Column& x, std::size_t k) {
    const double before = k == 0 ? -x[0] : x[k - 1], after = k == x.size() ? 2 - x[k - 1] : x[k];
    return after - before;
}
/// The space of particle i: half of what lies between its neighbours in the order of labels.
inline double space_of(const Column& x, std::size_t i) {
    return 0.5 * (gap(x, i) + gap(x, i + 1));
}

/// How particles move.
class Frame {
  public:
    virtual ~Frame() = default;
    virtual bool moves() const { return true; }
    /// Before a step of length dt.
    virtual void begin_step(BurgersParticles&, double /*dt*/) {}
    /// The velocities w at the present state; `rows` are those of the present positions.
    virtual void velocities(BurgersParticles& particles, const Rows<1>& rows) const = 0;
    /// Adds to du/dt what the equation does not have.
    virtual void add_forces(BurgersParticles&) const {}
    /// The smoothing lengths at the present positions, where they change.
    virtual void smoothing_lengths(BurgersParticles&) const {}
};
struct Still final : Frame {
    bool moves() const override { return false; }
    void velocities(BurgersParticles& p, const Rows<1>&) const override {
        std::fill(p.w[0].begin(), p.w[0].end(), 0.0);
    }
};
struct Lagrangian final : Frame {
    void velocities(BurgersParticles& p, const Rows<1>&) const override { p.w[0] = p.v[0]; }
};
/// Each moves with a share of its neighbours' velocity: w_i = u_i + strength (<u>_i - u_i), with the value
/// <u> that the rows give (XSPH; Monaghan 2005, 10.2, has a plain sum).
struct SmoothedVelocity final : Frame {
    double strength;
    explicit SmoothedVelocity(double share) : strength{share} {}
    void velocities(BurgersParticles& p, const Rows<1>& rows) const override {
        rows.apply(0, p.v[0], Parity::odd, p.w[0]);
        for (std::size_t i = 0; i < p.size(); ++i)
            p.w[0][i] = (1 - strength) * p.v[0][i] + strength * p.w[0][i];
    }
};

/// Where rows come from: estimates between particles, or differences of a grid.
class RowSource {
  public:
    virtual ~RowSource() = default;
    /// The rows of particles where they are.
    virtual const Rows<1>& at(const BurgersParticles& particles) = 0;
    /// Whether the second derivative is the first one taken twice.
    virtual bool twice() const = 0;
    virtual Enlarged enlarged() const { return {}; }
};

class BurgersLine final : public Integrated<1> {
  public:
    BurgersParticles particles;

    /// `n` particles; `viscosity` gamma >= 0 [length^2/time].
    BurgersLine(std::size_t n, double viscosity, std::unique_ptr<RowSource> rows,
                std::unique_ptr<Frame> frame)
        : particles{n}, viscosity_{viscosity}, source_{std::move(rows)}, frame_{std::move(frame)} {
        this->offer(particles);
        if (frame_->moves()) motion_.evolve<Position, FrameVelocity>(particles);
        motion_.evolve<Velocity, Acceleration>(particles);
        integrate_by<RungeKutta4>();
    }

    bool step(double& t, double dt) override {
        frame_->begin_step(particles, dt);
        return Integrated<1>::step(t, dt);
    }

    // [rates]
    void rates(double t) override {
        if (frame_->moves() || rows_ == nullptr) resolve(t);
        const Column& u = particles.v[0];
        if (source_->twice()) {
            rows_->apply(1, u, Parity::odd, u_x_);
            rows_->apply(1, u_x_, Parity::even, u_xx_);
        } else {
            rows_->apply_both(u, u_x_, u_xx_);
        }
        frame_->velocities(particles, *rows_);
        for (std::size_t i = 0; i < particles.size(); ++i)
            particles.dv_dt[0][i] = viscosity_ * u_xx_[i] + (particles.w[0][i] - u[i]) * u_x_[i];
        frame_->add_forces(particles);
        for (const std::size_t i : pinned_) particles.w[0][i] = particles.dv_dt[0][i] = 0;
        ++evaluations_;
    }
    // [end]

    void start(double /*t*/) override { rows_ = nullptr; }
    /// Throws Unstable for particles far beyond the line, and for |u| > 10: no solution exceeds the largest
    /// |u| of its start, which is 1.
    void require_bounded(double t) const {
        constexpr double far = 100, fast = 10;
        for (std::size_t i = 0; i < particles.size(); ++i) {
            const double x = particles.x[0][i], u = particles.v[0][i];
            if (!(std::abs(x) < far)) throw Unstable{t, i, "position", x};
            if (!(std::abs(u) < fast)) throw Unstable{t, i, "velocity", u};
        }
    }
    void resolve(double t) override {
        require_bounded(t);
        frame_->smoothing_lengths(particles);
        rows_ = &source_->at(particles);
        u_x_.resize(particles.size()), u_xx_.resize(particles.size());
    }
    /// The carried mass, and the integral of u: the sum of u times the space of each particle.
    Totals<1> totals() const override {
        Totals<1> all;
        for (std::size_t i = 0; i < particles.size(); ++i) {
            all.mass += particles.carried[i];
            all.momentum[0] += particles.v[0][i] * space_of(particles.x[0], i);
        }
        return all;
    }
    /// Those that neither move nor change their u.
    void pin(std::vector<std::size_t> which) { pinned_ = std::move(which); }
    const Rows<1>& rows() const { return *rows_; }
    Enlarged enlarged() const { return source_->enlarged(); }
    long evaluations() const { return evaluations_; }
    Groups& groups() override { return particles.groups; }
    Counters& counters() override { return counters_; }

  private:
    double viscosity_;
    std::unique_ptr<RowSource> source_;
    std::unique_ptr<Frame> frame_;
    const Rows<1>* rows_ = nullptr;
    std::vector<std::size_t> pinned_;
    Column u_x_, u_xx_;
    long evaluations_ = 0;
    Counters counters_;
};

}  // namespace sph
