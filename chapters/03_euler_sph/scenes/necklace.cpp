#include "chapters/03_euler_sph/scenes/necklace.hpp"

namespace sph::euler {
namespace {

using K = AnyKernel<2>;
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
class Flow : public Stepper {
  public:
    explicit Flow(const NecklaceScene& scene)
        : smoothing_{scene.h_over_dx / static_cast<double>(scene.per_side), K{"quintic"}},
          gas_{scene.per_side * scene.per_side,
               {smoothing_.h, smoothing_.kernel},
               {{0.5}},
               periodic_unit_box<2>(),
               scene.threads},
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
        for (Tracers* tracers : {&tracers_, &carried_}) moved_.evolve<Position, Velocity>(*tracers);
        pushed_.evolve<Velocity, Acceleration>(tracers_);
        gas_.resolve(0);
        carry();
    }
    bool step(double& t, double dt) override {
        drift(dt / 2);
        gas_.rates(t + dt / 2);
        sum_around(tracers_, Effects{TracerForce{1}});
        gas_.motion().kick(dt);
        pushed_.kick(dt);
        carry();
        drift(dt / 2);
        carry();
        t += dt;
        gas_.motion().require_physical(t);
        return true;
    }
    VortexGas& gas() { return gas_; }
    const Tracers& tracers() const { return tracers_; }
    const Tracers& carried() const { return carried_; }
    double h() const { return smoothing_.h; }

  private:
    void drift(double dt) {
        moved_.kick(dt);  // the velocities are no values of this motion
        gas_.motion().drift(dt);
    }
    void carry() { sum_around(carried_, Effects{CarriedVelocity{}}); }
    template <class E>
    void sum_around(Tracers& p, const E& effects) {
        around_.find_around(p.x, std::array{smoothing_.reach()}, gas_.particles.x, Keep::nothing);
        sum_over_neighbours(p, gas_.particles, around_, smoothing_, effects);
    }

    ConstantH<K> smoothing_;
    VortexGas gas_;
    Tracers tracers_, carried_;
    Motion moved_, pushed_;
    Neighbours<2, Box<2>> around_;
};

}  // namespace

NecklaceRun run_necklace(const NecklaceScene& scene) {
    Flow flow{scene};
    NecklaceRun run;
    run.start = flow.tracers().x;
    Drifts drifts{flow.gas()};
    const auto look = [&](double t) {
        run.t.push_back(t);
        run.circulation.push_back(circulation(flow.tracers()));
        run.carried.push_back(circulation(flow.carried()));
        run.drift = std::max(run.drift, std::abs(run.circulation.back() / run.circulation[0] - 1));
        run.carried_drift = std::max(run.carried_drift, std::abs(run.carried.back() / run.carried[0] - 1));
        flow.gas().resolve(t);
        drifts.look();
    };
    look(0);
    const double longest = scene.courant * flow.h() / (1 + scene.mach);
    double t = 0;
    march(flow, t, {.end = scene.time, .steps = std::lround(std::ceil(scene.time / longest))}, look);
    run.energy_drift = drifts.energy() / (square(scene.mach) / 4);
    run.end = flow.tracers().x;
    return run;
}

}  // namespace sph::euler
