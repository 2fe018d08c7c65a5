#include "tests/bench/switched.hpp"

#include <cmath>

namespace bench {
namespace {

template <class E>
struct OnTiles : VirtualTiles::Effect {
    void add(const VirtualTiles::I& i, const VirtualTiles::J& j, const VirtualTiles::Pair& pair,
             VirtualTiles::Sum& sum) const override {
        E{}.add(i, j, pair, sum);
    }
};

using Particle = OnePairAtATime::Particle;
using Terms = OnePairAtATime::Terms;

void density(Particle& i, const Particle& j, const Terms& pair) {
    i.rho_sum += j.m * pair.W;
}
void continuity(Particle& i, const Particle& j, const Terms& pair) {
    i.drho_dt += j.m * pair.F * pair.approach;
}
void pressure(Particle& i, const Particle& j, const Terms& pair) {
    const double force = j.m * pair.F * (i.p / (i.rho * i.rho) + j.p / (j.rho * j.rho));
    for (int a = 0; a < 3; ++a) i.dv_dt[a] -= force * pair.x[a];
}
void heating(Particle& i, const Particle& j, const Terms& pair) {
    i.du_dt += j.m * pair.F * i.p / (i.rho * i.rho) * pair.approach;
}
void viscosity(Particle& i, const Particle& j, const Terms& pair) {
    if (pair.approach >= 0) return;
    const double r2 = pair.x[0] * pair.x[0] + pair.x[1] * pair.x[1] + pair.x[2] * pair.x[2];
    const double mu = pair.h * pair.approach / (r2 + 0.01 * pair.h * pair.h);
    const double Pi = mu * (2 * mu - 0.5 * (i.c_s + j.c_s)) / (0.5 * (i.rho + j.rho));
    const double force = j.m * Pi * pair.F;
    for (int a = 0; a < 3; ++a) i.dv_dt[a] -= force * pair.x[a];
    i.du_dt += 0.5 * force * pair.approach;
}

template <void (*function)(Particle&, const Particle&, const Terms&)>
struct OnPairs : OnePairAtATime::Effect {
    void add(Particle& i, const Particle& j, const Terms& pair) const override { function(i, j, pair); }
};

}  // namespace

VirtualTiles::VirtualTiles(Switches on) {
    const auto use = [&](bool wanted, auto effect) {
        if (wanted) effects_.push_back(std::make_shared<decltype(effect)>(effect));
    };
    use(on.density, OnTiles<sph::SummedDensity>{});
    use(on.continuity, OnTiles<Continuity>{});
    use(on.pressure, OnTiles<PressureForce>{});
    use(on.heating, OnTiles<PressureHeating>{});
    use(on.viscosity, OnTiles<ArtificialViscosity>{});
}

OnePairAtATime::OnePairAtATime(const Gas<3>& gas, Switches on) : h_{gas.smoothing.h}, on_{on} {
    const auto& neighbours = gas.neighbours;
    for (std::size_t k = 0; k < neighbours.sources(); ++k) {
        const std::uint32_t owner = neighbours.owner(k);
        const auto row =
            sph::load<3>(gas.particles, owner,
                         sph::List<sph::Velocity, sph::Mass, sph::Density, sph::Pressure, sph::SoundSpeed>{});
        const auto x = neighbours.source_position(k);
        particles_.push_back({{x[0], x[1], x[2]},
                              {row.v[0], row.v[1], row.v[2]},
                              row.m,
                              row.rho,
                              row.p,
                              row.c_s,
                              0,
                              0,
                              {0, 0, 0},
                              0});
    }
    sph::Indices scratch;
    for (std::size_t r = 0; r < neighbours.receivers().size(); ++r) {
        const auto [index, count] = neighbours.of(r, scratch);
        start_.push_back(list_.size());
        list_.insert(list_.end(), index, index + count);
    }
    start_.push_back(list_.size());
    // The receivers are the particles among the sources, met in the order of the passes.
    neighbours.cells().for_each_block_run([&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            if (neighbours.ghost(k) == nullptr) receiver_.push_back(static_cast<std::uint32_t>(k));
        }
    });
    if (on.density) effects_.push_back(std::make_unique<OnPairs<density>>());
    if (on.continuity) effects_.push_back(std::make_unique<OnPairs<continuity>>());
    if (on.pressure) effects_.push_back(std::make_unique<OnPairs<pressure>>());
    if (on.heating) effects_.push_back(std::make_unique<OnPairs<heating>>());
    if (on.viscosity) effects_.push_back(std::make_unique<OnPairs<viscosity>>());
}

template <class Add>
void OnePairAtATime::for_each_pair(Add&& add) {
    using K = sph::CubicSpline<3>;
    for (std::size_t r = 0; r < receiver_.size(); ++r) {
        Particle& i = particles_[receiver_[r]];
        i.rho_sum = i.drho_dt = i.du_dt = 0;
        for (double& component : i.dv_dt) component = 0;
        for (std::size_t k = start_[r]; k < start_[r + 1]; ++k) {
            const Particle& j = particles_[list_[k]];
            Terms pair{};
            double r2 = 0;
            for (int a = 0; a < 3; ++a) {
                pair.x[a] = i.x[a] - j.x[a];
                r2 += pair.x[a] * pair.x[a];
                pair.approach += (i.v[a] - j.v[a]) * pair.x[a];
            }
            const double distance = std::sqrt(r2);
            pair.W = K::W(distance, h_);
            pair.F = K::F(distance, h_);
            pair.h = h_;
            add(i, j, pair);
        }
    }
}

template <Switches on>
void OnePairAtATime::listed_for() {
    for_each_pair([](Particle& i, const Particle& j, const Terms& pair) {
        if constexpr (on.density) density(i, j, pair);
        if constexpr (on.continuity) continuity(i, j, pair);
        if constexpr (on.pressure) pressure(i, j, pair);
        if constexpr (on.heating) heating(i, j, pair);
        if constexpr (on.viscosity) viscosity(i, j, pair);
    });
}

/// Compiled for each scene of the bench.
void OnePairAtATime::listed() {
    const auto is = [this](Switches other) { return on_ == other; };
    if (is({.density = true})) return listed_for<Switches{.density = true}>();
    if (is({.continuity = true})) return listed_for<Switches{.continuity = true}>();
    if (is({.pressure = true})) return listed_for<Switches{.pressure = true}>();
    if (is({.heating = true})) return listed_for<Switches{.heating = true}>();
    if (is({.viscosity = true})) return listed_for<Switches{.viscosity = true}>();
    if (is({.pressure = true, .viscosity = true}))
        return listed_for<Switches{.pressure = true, .viscosity = true}>();
    listed_for<Switches{true, true, true, true, true}>();
}

void OnePairAtATime::with_ifs() {
    for_each_pair([this](Particle& i, const Particle& j, const Terms& pair) {
        if (on_.density) density(i, j, pair);
        if (on_.continuity) continuity(i, j, pair);
        if (on_.pressure) pressure(i, j, pair);
        if (on_.heating) heating(i, j, pair);
        if (on_.viscosity) viscosity(i, j, pair);
    });
}

void OnePairAtATime::with_virtual_calls() {
    for_each_pair([this](Particle& i, const Particle& j, const Terms& pair) {
        for (const auto& effect : effects_) effect->add(i, j, pair);
    });
}

}  // namespace bench
