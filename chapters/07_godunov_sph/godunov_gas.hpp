#pragma once
#include "chapters/04_artificial_viscosity/dissipative_gas.hpp"
#include "chapters/07_godunov_sph/godunov_force.hpp"

/// A gas whose pairs solve Riemann problems.
namespace sph {

/// What a Godunov gas is made of: sides_of_face.hpp, volumes.hpp, riemann.hpp, godunov_force.hpp; and, where
/// it conducts, chapter 4's conduction.hpp.
template <class Sides_, class Volumes_, class Solver_, class Limit_, class Conducts_ = NoConduction>
struct Godunov {
    using Sides = Sides_;
    using Volumes = Volumes_;
    using Solver = Solver_;
    using Limit = Limit_;
    using Conducts = Conducts_;
    Sides sides{};
    Volumes volumes{};
    Solver solver{};
    Limit limit{};
    Conducts conduction{};
    bool retries = true;          ///< a step that fails is done again, shorter, and at last without slopes
    bool total_energy = false;    ///< v^2/2 + u evolves in the place of u
    long calm = 0;                ///< first steps that are done without slopes
    bool single_storage = false;  ///< positions, velocities and energies keep 24 bits
    static auto parts(auto& self) {
        return std::tie(self.sides, self.volumes, self.solver, self.limit, self.conduction);
    }
};

namespace godunov_gas_detail {
template <class Scheme>
using Slopes = Union<typename Scheme::Sides::Slopes, typename Scheme::Volumes::Slopes>;
template <class Scheme>
using More =
    Union<List<Acceleration, SoundSpeed, ThermalEnergy, Heating, StepRate, SmoothingLength>, Slopes<Scheme>>;
using Saved = List<Position, Velocity, ThermalEnergy, SmoothingLength>;
template <class... E, class... More>
auto effects(List<E...>, const More&... more) {
    return Effects{E{}..., more...};
}
}  // namespace godunov_gas_detail

/// The paper's step   (Inutsuka 2002, 83-88): one evaluation of the forces, at its beginning, and
///     v_1 = v + dt a,   x_1 = x + dt (v + v_1)/2,   u_1 = u + dt (du/dt - dt/2 a^2).
/// With the last term the heat of each pair is its work P* (v* - (v + v_1)/2): energy is conserved to
/// rounding, whatever h, slopes and solver are. Density, h, slopes and the limit of the next step belong to
/// the end. A step that leaves an energy that is not > 0, or that would have to be less than half as long
/// with the limit found at its end, is done again, half as long; from the second time on without slopes.
/// Resolution: h for each particle, and a kernel with wide_F.
template <class Resolution, class Scheme, class Boundary = Free>
class GodunovGas
    : public RateLimited<Resolution, Boundary, godunov_gas_detail::More<Scheme>, godunov_gas_detail::Saved> {
    using Base =
        RateLimited<Resolution, Boundary, godunov_gas_detail::More<Scheme>, godunov_gas_detail::Saved>;
    using Kernel = typename Resolution::Kernel;

  public:
    static constexpr int d = Base::d;
    using Base::particles;

    /// Throws std::invalid_argument for a gas that is not ideal.
    GodunovGas(std::size_t n, Resolution resolution, ThermalState state, Scheme scheme, Boundary boundary,
               double courant, int threads)
        : Base{n, std::move(resolution), std::move(boundary), courant, threads},
          state_{std::move(state)},
          scheme_{std::move(scheme)} {
        const auto* ideal = state_.template as<IdealGas>();
        if (!ideal) throw std::invalid_argument{"the Riemann problem is solved for an ideal gas only"};
        gamma_ = ideal->gamma;
    }

    void start(double t) override {
        this->time_ = t;
        this->resolution_.start(particles);
        state_.set_energy(particles.rho, particles.p, particles.u);
    }
    void resolve(double t) override {
        this->find_density(t);
        state_.set_pressure(particles.rho, particles.u, particles.p);
        state_.set_sound_speed(particles.rho, particles.u, particles.c_s);
    }
    Totals<d> totals() const override { return this->thermal_totals(); }

  private:
    void first_rates(double t) override { prepare(t); }
    bool advance(double t, double dt) override;
    /// Density, slopes and the limit of the next step at the present state.
    void prepare(double t) {
        resolve(t);
        this->sum(godunov_gas_detail::effects(godunov_gas_detail::Slopes<Scheme>{}, scheme_.limit));
        stale_ = false;
    }
    void forces(double dt);
    void move(std::size_t i, double dt, double moved);
    void move_all(double dt);
    /// The step is to be done again: what it has left in sums beside the columns.
    bool undo(const Totals<d>& given) {
        this->given_ = given;
        stale_ = true;
        ++failures_;
        return false;
    }

    ThermalState state_;
    Scheme scheme_;
    double gamma_ = 0;
    bool stale_ = false;  // whether the particles were moved since prepare()
    int failures_ = 0;    // of this step
    long steps_ = 0;      // done
};

template <class R, class S, class B>
void GodunovGas<R, S, B>::forces(double dt) {
    constexpr int without_slopes = 2;  // failures after which a step is done without them
    const double order = failures_ < without_slopes && steps_ >= scheme_.calm ? 1.0 : 0.0;
    const StepOfSides step{dt, gamma_, Kernel::bend, Kernel::reach2, order};
    const RiemannForce<typename S::Sides, typename S::Volumes, typename S::Solver, Kernel> force{
        scheme_.sides, scheme_.volumes, scheme_.solver, step};
    if constexpr (std::is_same_v<typename S::Conducts, NoConduction>) {
        this->sum(Effects{force});
    } else {
        this->sum(Effects{force, scheme_.conduction});
    }
}

/// v, x and u of particle i after the step; `moved` is 0 for one that is held.
template <class R, class S, class B>
void GodunovGas<R, S, B>::move(std::size_t i, double dt, double moved) {
    const auto stored = [&](double value) {
        return scheme_.single_storage ? static_cast<double>(static_cast<float>(value)) : value;
    };
    auto& p = particles;
    double gained2 = 0, before2 = 0, after2 = 0, work = 0;
    for (std::size_t a = 0; a < d; ++a) {
        const double v = p.v[a][i], dv = moved * dt * p.dv_dt[a][i];
        p.x[a][i] = stored(p.x[a][i] + dt * (v + 0.5 * dv));
        p.v[a][i] = stored(v + dv);
        gained2 += dv * dv, before2 += v * v, after2 += p.v[a][i] * p.v[a][i], work += v * p.dv_dt[a][i];
    }
    if (scheme_.total_energy && moved > 0) {
        const double e = stored(0.5 * before2 + p.u[i] + dt * (p.du_dt[i] + work));
        p.u[i] = e - 0.5 * after2;
    } else {
        p.u[i] = stored(p.u[i] + dt * p.du_dt[i] - 0.5 * gained2);
    }
}

/// All of them. Held ones keep their velocity: their momentum goes to given_, and their heat is that of the
/// velocity that they have.
template <class R, class S, class B>
void GodunovGas<R, S, B>::move_all(double dt) {
    auto& p = particles;
    p.groups.for_each_free(p.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) move(i, dt, 1);
    });
    for (const Group& group : p.groups.held()) {
        for (std::size_t i = group.begin; i < group.end; ++i) {
            for (std::size_t a = 0; a < d; ++a) {
                this->given_.momentum[a] += dt * p.m[i] * p.dv_dt[a][i];
                this->given_.energy += dt * p.m[i] * p.dv_dt[a][i] * p.v[a][i];
            }
            move(i, dt, 0);
        }
    }
}

// [advance]
template <class R, class S, class B>
bool GodunovGas<R, S, B>::advance(double t, double dt) {
    if (stale_) prepare(t);
    const Totals<d> given = this->given_;
    forces(dt);
    move_all(dt);
    const auto positive = [](double u) { return u > 0; };
    if (scheme_.retries && !std::all_of(particles.u.begin(), particles.u.end(), positive)) return undo(given);
    this->require_physical_columns(List<Position, Velocity, ThermalEnergy>{}, t + dt);
    prepare(t + dt);
    if (scheme_.retries && this->too_long(dt)) return undo(given);
    failures_ = 0;
    ++steps_;
    return true;
}
// [end]

}  // namespace sph
