#include "chapters/09_transverse_expansion/scenes/plateau.hpp"

#include <cmath>

#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "chapters/04_artificial_viscosity/scenes/plane_lattice.hpp"
#include "chapters/08_landau_model/fluids.hpp"
#include "chapters/09_transverse_expansion/curved_fluid.hpp"

namespace sph::transverse {
namespace {

using K3 = AnyKernel<3>;
using SpaceResolution = WithoutOmega<K3, OfCurvedEntropy>;
using SpaceFluid = CurvedFluid<SpaceResolution, ConformalFluid, Hyperbolic>;

/// Layers of one spiral, each turned against the one below; eta in units of `unit`, in which layers are as
/// far apart as particles of a layer are at the start.
std::unique_ptr<SpaceFluid> plateau_fluid(const PlateauScene& scene, const Disc& disc, double unit) {
    constexpr double h_over_dx = 1.8, close = 1e-4, turn = 0.7;  // [rad], no multiple of the golden angle
    const double spacing = PlateauScene::R * std::sqrt(pi / static_cast<double>(scene.per_layer));
    const auto layers = static_cast<std::size_t>(std::lround(2 * scene.half * unit / spacing));
    const double height = 2 * scene.half * unit / static_cast<double>(layers);
    const std::size_t per_layer = disc.area.size(), n = layers * per_layer;
    auto fluid = std::make_unique<SpaceFluid>(n, SpaceResolution{HRule{h_over_dx}, close, K3{"wendland-c4"}},
                                              ConformalFluid{}, Hyperbolic{unit}, Free{}, scene.threads);
    auto& p = fluid->particles;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t k = i % per_layer, layer = i / per_layer;
        const double c = std::cos(turn * static_cast<double>(layer)),
                     s = std::sin(turn * static_cast<double>(layer));
        p.x[0][i] = c * disc.x[0][k] - s * disc.x[1][k];
        p.x[1][i] = s * disc.x[0][k] + c * disc.x[1][k];
        p.x[2][i] = height * (static_cast<double>(layer) + 0.5) - scene.half * unit;
        p.s_star[i] = PlateauScene::tau0 / unit;
        p.nu[i] = disc.area[k] * height * p.s_star[i];
    }
    // Masses that make s* even, as in the plane, in three rounds.
    const Column wanted = p.s_star;
    for (int round = 0; round < 3; ++round) {
        p.s_star = wanted;
        fluid->start(PlateauScene::tau0);
        fluid->resolve(PlateauScene::tau0);
        for (std::size_t i = 0; i < n; ++i) p.nu[i] *= std::clamp(wanted[i] / p.s_star[i], 1 / 1.3, 1.3);
    }
    p.s_star = wanted;
    fluid->start(PlateauScene::tau0);
    fluid->integrate_by<RungeKutta4>();
    fluid->limit_steps([&space = *fluid, courant = scene.courant, longest = 0.0]() mutable {
        const double allowed =
            std::min(courant * space.crossing_time(space.resolved_at()), 0.1 * space.resolved_at());
        longest = longest > 0 ? std::min(1.1 * longest, allowed) : 0.05 * allowed;
        return longest;
    });
    return fluid;
}

}  // namespace

PlateauRun run_plateau(const PlateauScene& scene) {
    constexpr double unit = 3, near = 0.8;  // spacings: the layers next to eta = 0
    const Flow flow = cylinder(PlateauScene::R, PlateauScene::tau0, 1.0 / 3);
    const PlaneMethod& method = plane_methods()["spiral-solved"];
    const PlaneScene plane{.n = scene.per_layer, .times = {scene.time}, .threads = scene.threads};
    const Snapshot flat = run_plane(flow, plane, method).back();
    const auto start = plane_fluid(flow, plane, method);
    const Disc disc{start->get<Position>(), start->get<Entropy>()};  // s* = 1 there: the masses are areas
    const auto fluid = plateau_fluid(scene, disc, unit);
    PlateauRun run;
    double tau = PlateauScene::tau0;
    fluid->resolve(tau);
    run.seconds = march(*fluid, tau, {.end = scene.time}).seconds;
    fluid->resolve(tau);
    run.n = fluid->size();
    run.counters = fluid->counters();
    const FlowProfile exact = flow.exact(tau);
    const auto& p = fluid->particles;
    const double middle = near * PlateauScene::R * std::sqrt(pi / static_cast<double>(scene.per_layer));
    Column area;
    double difference = 0, whole = 0;
    for (std::size_t i = 0; i < run.n; ++i) {
        if (std::abs(p.x[2][i]) > middle) continue;
        const double r = std::hypot(p.x[0][i], p.x[1][i]);
        run.r.push_back(r), run.temperature.push_back(std::cbrt(fluid->entropy(i, tau)));
        run.u_r.push_back((p.U[0][i] * p.x[0][i] + p.U[1][i] * p.x[1][i]) / r);
        run.eta_velocity.push_back(p.v[2][i] / unit);
        area.push_back(p.nu[i] / p.s_star[i]);
        if (r >= PlateauScene::R) continue;
        difference += area.back() * std::abs(run.temperature.back() - exact(r).temperature);
        whole += area.back() * exact(r).temperature;
    }
    run.l1_temperature = difference / whole;
    run.plane_l1_temperature = flat.l1_temperature;
    run.plane_r = flat.r, run.plane_temperature = flat.temperature;
    constexpr double dr = 1;
    const auto rings = shocks::ring_means(run.r, run.temperature, area, dr, PlateauScene::R),
               plane_rings = shocks::ring_means(flat.r, flat.temperature, flat.area, dr, PlateauScene::R);
    run.rings_r = rings.r, run.rings = rings.value, run.plane_rings = plane_rings.value;
    difference = whole = 0;
    for (std::size_t k = 0; k < std::min(rings.r.size(), plane_rings.r.size()); ++k) {
        difference += rings.r[k] * std::abs(rings.value[k] - plane_rings.value[k]);
        whole += rings.r[k] * plane_rings.value[k];
    }
    run.difference = difference / whole;
    return run;
}

}  // namespace sph::transverse
