#include "chapters/03_euler_sph/scenes/necklace.hpp"

namespace sph {
namespace {

using K = QuinticSpline<2>;
using VortexGas = Gas<FixedH<K>, Barotropic<Quadratic>, Box<2>>;
using Tracers = Particles<2, Position, Velocity, Acceleration>;

/// v = M (sin 2 pi x cos 2 pi y, -cos 2 pi x sin 2 pi y): no divergence; vortices around odd quarters.
Vector<2> vortex(double x, double y, double mach) {
    const double k = 2 * pi;
    return {mach * std::sin(k * x) * std::cos(k * y), -mach * std::cos(k * x) * std::sin(k * y)};
}

/// C = 1/2 sum v_l . (r_{l+1} - r_{l-1})   (5.19)
double circulation(const Tracers& p) {
    const std::size_t n = p.size();
    double sum = 0;
    for (std::size_t l = 0; l < n; ++l) {
        const std::size_t next = (l + 1) % n, last = (l + n - 1) % n;
        for (std::size_t a = 0; a < 2; ++a) sum += 0.5 * p.v[a][l] * (p.x[a][next] - p.x[a][last]);
    }
    return sum;
}

/// The gas and both necklaces, advanced together by drift-kick-drift.
class Flow {
  public:
    explicit Flow(const NecklaceScene& scene)
        : h_{scene.h / static_cast<double>(scene.per_side)},
          gas_{
              scene.per_side * scene.per_side, FixedH<K>{h_}, {{0.5}}, periodic_unit_box<2>(), scene.threads},
          tracers_{scene.tracers},
          carried_{scene.tracers},
          around_{periodic_unit_box<2>(), scene.threads} {
        auto& p = gas_.particles;
        p.x = make_points<2>(Arrangement::even, scene.per_side, 0, 1);
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Vector<2> v = vortex(p.x[0][i], p.x[1][i], scene.mach);
            for (std::size_t a = 0; a < 2; ++a) p.v[a][i] = v[a];
            p.m[i] = 1 / static_cast<double>(p.size());
        }
        for (std::size_t l = 0; l < scene.tracers; ++l) {
            const double angle = 2 * pi * static_cast<double>(l) / static_cast<double>(scene.tracers);
            const Vector<2> x{0.25 + scene.radius * std::cos(angle), 0.25 + scene.radius * std::sin(angle)};
            const Vector<2> v = vortex(x[0], x[1], scene.mach);
            for (std::size_t a = 0; a < 2; ++a) {
                tracers_.x[a][l] = carried_.x[a][l] = x[a];
                tracers_.v[a][l] = carried_.v[a][l] = v[a];
            }
        }
        gas_.resolve(0);
        carry();
    }
    void step(double dt) {
        drift(dt / 2);
        gas_.rates(t_ + dt / 2);
        force();
        using Motion = VortexGas::Motion;
        Motion::kick(gas_.particles, dt);
        Motion::kick(tracers_, dt);
        carry();
        drift(dt / 2);
        carry();
        t_ += dt;
        Motion::require_physical(gas_.particles, t_);
    }
    VortexGas& gas() { return gas_; }
    const Tracers& tracers() const { return tracers_; }
    const Tracers& carried() const { return carried_; }
    double h() const { return h_; }

  private:
    void drift(double dt) {
        for (auto* p : {&tracers_, &carried_}) VortexGas::Motion::drift(*p, dt);
        VortexGas::Motion::drift(gas_.particles, dt);
    }
    void force() {
        find_around(tracers_);
        sum_over_neighbours(tracers_, gas_.particles, around_, ConstantH<K>{h_}, Effects{TracerForce{1}});
    }
    void carry() {
        find_around(carried_);
        sum_over_neighbours(carried_, gas_.particles, around_, ConstantH<K>{h_}, Effects{CarriedVelocity{}});
    }
    void find_around(const Tracers& p) {
        around_.find_around(p.x, std::array{K::support * h_}, gas_.particles.x, Keep::nothing);
    }

    double h_, t_ = 0;
    VortexGas gas_;
    Tracers tracers_, carried_;
    Neighbours<2, Box<2>> around_;
};

}  // namespace

NecklaceRun run_necklace(const NecklaceScene& scene) {
    Flow flow{scene};
    NecklaceRun run;
    run.start = flow.tracers().x;
    const double first = circulation(flow.tracers()), first_carried = circulation(flow.carried());
    const double energy = flow.gas().energy(), motion = square(scene.mach) / 4;
    const double dt_most = scene.courant * flow.h() / (1 + scene.mach);
    const auto steps = static_cast<int>(std::ceil(scene.time / dt_most));
    for (int k = 0; k <= steps; ++k) {
        if (k > 0) flow.step(scene.time / steps);
        run.t.push_back(scene.time * k / steps);
        run.circulation.push_back(circulation(flow.tracers()));
        run.carried.push_back(circulation(flow.carried()));
        run.drift = std::max(run.drift, std::abs(run.circulation.back() / first - 1));
        run.carried_drift = std::max(run.carried_drift, std::abs(run.carried.back() / first_carried - 1));
        flow.gas().resolve(run.t.back());
        run.energy_drift = std::max(run.energy_drift, std::abs(flow.gas().energy() - energy) / motion);
    }
    run.end = flow.tracers().x;
    return run;
}

}  // namespace sph
