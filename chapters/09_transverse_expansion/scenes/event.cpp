#include "chapters/09_transverse_expansion/scenes/event.hpp"

#include <cmath>
#include <complex>

#include "chapters/08_landau_model/entropic_fluid.hpp"
#include "common/core/arrangement.hpp"

namespace sph::transverse {
namespace {

/// The density of entropy at rest: the same integral as that of s = 1 over the disc of the spots.
class HotSpots {
  public:
    explicit HotSpots(const EventScene& scene) {
        Uniform uniform{scene.seed};
        while (static_cast<long>(places_.size()) < scene.spots) {
            const Vector<2> x{(2 * uniform() - 1) * EventScene::disc, (2 * uniform() - 1) * EventScene::disc};
            if (dot(x, x) < square(EventScene::disc)) places_.push_back(x);
        }
        height_ =
            square(EventScene::disc) / (2 * square(EventScene::width) * static_cast<double>(scene.spots));
    }
    double operator()(const Vector<2>& x) const {
        double sum = 0;
        for (const Vector<2>& spot : places_)
            sum += std::exp(-0.5 * dot(x - spot, x - spot) / square(EventScene::width));
        return height_ * sum;
    }

  private:
    std::vector<Vector<2>> places_;
    double height_;
};

double harmonic(int n, const Column& x, const Column& y, const Column& weight, int power) {
    std::complex<double> sum = 0;
    double whole = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double by = weight[i] * std::pow(std::hypot(x[i], y[i]), power);
        sum += by * std::polar(1.0, n * std::atan2(y[i], x[i]));
        whole += by;
    }
    return std::abs(sum) / whole;
}

std::array<double, 2> eccentricities(const Integrated<2>& fluid) {
    const Column& nu = fluid.get<Entropy>();
    Column x = fluid.get<Position>()[0], y = fluid.get<Position>()[1];
    double all = 0, mean_x = 0, mean_y = 0;
    for (std::size_t i = 0; i < nu.size(); ++i) all += nu[i], mean_x += nu[i] * x[i], mean_y += nu[i] * y[i];
    for (std::size_t i = 0; i < nu.size(); ++i) x[i] -= mean_x / all, y[i] -= mean_y / all;
    return {harmonic(2, x, y, nu, 2), harmonic(3, x, y, nu, 3)};
}
std::array<double, 2> flows(const Integrated<2>& fluid) {
    const auto& q = fluid.get<MomentumPerCharge>();
    const Column& nu = fluid.get<Entropy>();
    return {harmonic(2, q[0], q[1], nu, 1), harmonic(3, q[0], q[1], nu, 1)};
}

EventFrame frame_of(const Integrated<2>& fluid, double tau) {
    EventFrame frame{tau, fluid.get<Position>()[0],     fluid.get<Position>()[1],
                     {},  fluid.get<FourVelocity>()[0], fluid.get<FourVelocity>()[1]};
    for (std::size_t i = 0; i < frame.x.size(); ++i)
        frame.temperature.push_back(
            std::cbrt(fluid.get<EntropyDensity>()[i] /
                      (tau * std::sqrt(1 + square(frame.u_x[i]) + square(frame.u_y[i])))));
    return frame;
}

std::unique_ptr<Integrated<2>> event_fluid(const EventScene& scene) {
    constexpr double least = 1e-4;  // thinner matter is left out: a ten-thousandth of the entropy
    const HotSpots spots{scene};
    const Disc disc = spiral_disc(scene.n, EventScene::reach, [](double) { return 1.0; });
    Columns<2> x;
    Column nu, s_star;
    for (std::size_t i = 0; i < disc.area.size(); ++i) {
        const double s = spots({disc.x[0][i], disc.x[1][i]});
        if (s < least) continue;
        for (std::size_t a = 0; a < 2; ++a) x[a].push_back(disc.x[a][i]);
        s_star.push_back(scene.tau0 * s), nu.push_back(disc.area[i] * scene.tau0 * s);
    }
    const PlaneMethod& method = plane_methods().recommended();
    auto fluid = method.make(
        {nu.size(), EventScene::reach, 1.0 / 3, x, scene.courant, Order::fourth, true, scene.threads});
    fluid->get<Position>() = x;
    fluid->get<Entropy>() = nu;
    solve_masses(*fluid, s_star, scene.tau0, 0);
    fluid->start(scene.tau0);
    return fluid;
}

}  // namespace

EventRun run_event(const EventScene& scene) {
    const auto fluid = event_fluid(scene);
    EventRun run;
    run.eccentricity = eccentricities(*fluid);
    double tau = scene.tau0;
    fluid->resolve(tau);
    for (const double end : scene.times) {
        if (end > tau) run.seconds += march(*fluid, tau, {.end = end, .progress = scene.progress}).seconds;
        fluid->resolve(tau);
        run.frames.push_back(frame_of(*fluid, tau));
    }
    run.flow = flows(*fluid);
    const Totals<2> totals = fluid->totals();
    double whole = 0;
    for (std::size_t i = 0; i < fluid->size(); ++i)
        whole += fluid->get<Entropy>()[i] *
                 std::hypot(fluid->get<MomentumPerCharge>()[0][i], fluid->get<MomentumPerCharge>()[1][i]);
    run.momentum = std::hypot(totals.momentum[0], totals.momentum[1]) / whole;
    run.counters = fluid->counters();
    return run;
}

}  // namespace sph::transverse
