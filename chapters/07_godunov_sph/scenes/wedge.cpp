#include "chapters/07_godunov_sph/scenes/wedge.hpp"

#include <algorithm>
#include <cmath>

#include "common/app/clock.hpp"
#include "common/core/unstable.hpp"

namespace sph::godunov {
namespace {

/// A gas in the channel, with the particles that come and go.
class Stream {
  public:
    Stream(const WedgeScene& scene, const ChannelMethod& method);
    /// What is to be done after each step.
    void look(double t);
    WedgeRun result(double seconds);
    Simulation<2>& gas() { return open_->gas(); }

  private:
    static constexpr long steps_between = 4;  // exchanges of particles: each costs a search and sums
    static constexpr double outflow = 4;      // spacings beyond the end to which particles are kept

    void bounce();
    void exchange(double t);
    void enter(std::size_t from, double t);
    double energy_of(std::size_t i);

    WedgeScene scene_;
    OpenChannel channel_;
    std::vector<PolygonWall> walls_;
    std::unique_ptr<OpenGas> open_;
    FlowMean mean_;
    Totals<2> first_;
    double entered_ = 0, left_ = 0, energy_ = 0, last_ = 0;  // energy_: what came less what went
    long steps_ = 0, through_ = 0;
};

Stream::Stream(const WedgeScene& scene, const ChannelMethod& method)
    : scene_{scene},
      channel_{scene.mirrors ? scene.channel.walls() : std::vector<PolygonWall>{},
               1 / static_cast<double>(scene.cells)},
      walls_{scene.channel.walls()},
      mean_{scene.channel.cells(scene.cells)} {
    const WedgeChannel& channel = scene.channel;
    const std::size_t n = scene.cells;
    open_ = method.make({3 * n * n, IdealGas{channel.gamma}, channel_, scene.courant, scene.threads});
    const double dx = channel_.spacing;
    for (std::size_t k = 0; k < 3 * n * n; ++k) {
        const double x = channel.begin + (static_cast<double>(k / n) + 0.5) * dx, low = channel.floor(x);
        const double y = low + (static_cast<double>(k % n) + 0.5) * (1 - low) * dx;
        gas().place(k, {x, y}, {channel.mach, 0}, dx * dx * (1 - low), 1, channel.pressure());
    }
    gas().start(0);
    gas().resolve(0);
    first_ = gas().totals();
}

double Stream::energy_of(std::size_t i) {
    const auto& v = gas().get<Velocity>();
    return gas().get<Mass>()[i] *
           (0.5 * (v[0][i] * v[0][i] + v[1][i] * v[1][i]) + gas().get<ThermalEnergy>()[i]);
}

/// The particles that have left go; the images that have passed the entry become particles.
void Stream::exchange(double t) {
    const Column& x = gas().get<Position>()[0];
    const Column& m = gas().get<Mass>();
    const double first = *std::min_element(x.begin(), x.end());
    std::vector<std::uint32_t> from;
    for (std::uint32_t i = 0; i < x.size(); ++i) {
        if (x[i] < WedgeChannel::end + outflow * channel_.spacing) {
            from.push_back(i);
        } else {
            left_ += m[i], energy_ -= energy_of(i);
        }
    }
    const std::size_t stay = from.size();
    for (std::uint32_t i = 0; i < x.size(); ++i) {
        if (channel_.is_repeated(x[i], first) && x[i] - channel_.period() > WedgeChannel::begin)
            from.push_back(i);
    }
    open_->take(from);
    enter(stay, t);
}

/// Those from number `from` on are copies of particles of the stream; they begin one period behind them.
void Stream::enter(std::size_t from, double t) {
    constexpr double disturbed = 0.1;
    const double u = scene_.channel.energy();
    Columns<2>& x = gas().get<Position>();
    Columns<2>& v = gas().get<Velocity>();
    for (std::size_t i = from; i < x[0].size(); ++i) {
        double& u_i = gas().get<ThermalEnergy>()[i];
        if (std::abs(u_i / u - 1) > disturbed)
            throw Unstable{
                t, i,
                "thermal energy of what enters (a disturbance has come to the entry), over the stream's,",
                u_i / u};
        x[0][i] -= channel_.period();
        v[0][i] = scene_.channel.mach, v[1][i] = 0, u_i = u;
        entered_ += gas().get<Mass>()[i], energy_ += energy_of(i);
    }
}

/// A particle that a step has carried through a wall changes places with its image: energy stays what it is.
void Stream::bounce() {
    Columns<2>& x = gas().get<Position>();
    Columns<2>& v = gas().get<Velocity>();
    const long before = through_;
    for (std::size_t i = 0; i < x[0].size(); ++i) {
        for (const PolygonWall& wall : walls_) {
            const auto* piece = wall.behind({x[0][i], x[1][i]});
            if (!piece) continue;
            ++through_;
            Vector<2> mirrored{v[0][i], v[1][i]};
            mirror(mirrored, piece->normal);
            const double depth = piece->before({x[0][i], x[1][i]});
            for (std::size_t a = 0; a < 2 && scene_.mirrors; ++a)
                x[a][i] -= 2 * depth * piece->normal[a], v[a][i] = mirrored[a];
        }
    }
    if (through_ > before && scene_.mirrors) gas().restart();
}

void Stream::look(double t) {
    bounce();
    const Columns<2>& x = gas().get<Position>();
    energy_ += scene_.channel.pressure() * scene_.channel.mach * (t - last_);  // the height is 1
    last_ = t;
    if (++steps_ % steps_between != 0) return;
    if (t > scene_.end() * 2 / 3) {
        const Columns<2>& v = gas().get<Velocity>();
        const Column &m = gas().get<Mass>(), &rho = gas().get<Density>(), &p = gas().get<Pressure>();
        for (std::size_t i = 0; i < rho.size(); ++i)
            mean_.add(x[0][i], x[1][i], m[i] / rho[i], {rho[i], v[0][i], v[1][i], p[i]});
    }
    exchange(t);
}

WedgeRun Stream::result(double seconds) {
    const Totals<2> now = gas().totals();
    WedgeRun run;
    run.flow = mean_.mean(scene_.channel.gamma);
    run.measured = measure(scene_.channel, run.flow);
    run.x = gas().get<Position>(), run.v = gas().get<Velocity>();
    run.rho = gas().get<Density>(), run.p = gas().get<Pressure>();
    for (std::size_t i = 0; i < run.rho.size(); ++i)
        run.mach.push_back(std::hypot(run.v[0][i], run.v[1][i]) / gas().get<SoundSpeed>()[i]);
    run.entered = entered_, run.left = left_, run.through = through_;
    run.mass_error = (first_.mass + entered_ - left_ - now.mass) / first_.mass;
    run.energy_error = (first_.energy + energy_ - now.energy) / first_.energy;
    run.counters = gas().counters();
    run.seconds = seconds;
    return run;
}

}  // namespace

WedgeRun run_wedge(const WedgeScene& scene, const ChannelMethod& method) {
    scene.channel.shock();  // throws where there is none
    Stream stream{scene, method};
    double t = 0;
    const Marched done = march(stream.gas(), t, {.end = scene.end(), .progress = scene.progress},
                               [&](double now) { stream.look(now); });
    stream.gas().resolve(t);
    return stream.result(done.seconds);
}

namespace {
WedgeGrid advanced(const WedgeChannel& channel, exact::FiniteVolumeChannel solver, double end) {
    const double seconds = app::thread_cpu_seconds([&] { solver.advance_to(end); });
    const ChannelFlow flow = flow_of(solver, channel.gamma);
    return {std::move(solver), flow, measure(channel, flow), seconds};
}
}  // namespace

WedgeGrid run_wedge_grid(const WedgeScene& scene) {
    const WedgeChannel& channel = scene.channel;
    return advanced(channel,
                    {channel.cells(scene.cells), {1, channel.mach, 0, channel.pressure()}, channel.gamma},
                    scene.end());
}
WedgeGrid refined(const WedgeScene& scene, const WedgeGrid& coarse) {
    const std::size_t n = 2 * coarse.flow.cells.ny;
    return advanced(scene.channel, {scene.channel.cells(n), coarse.solver},
                    coarse.solver.time() + scene.end() / 6);
}

report::Quantities WedgeRun::quantities() const {
    return {{"shock_angle", measured.beta, "degrees"},
            {"mach_behind_shock", measured.mach_behind},
            {"mach_after_fan", measured.mach_after},
            {"entropy_at_floor", measured.entropy_at_floor},
            {"entropy_above", measured.entropy_above},
            {"least_mach", measured.least_mach},
            {"least_mach_x", measured.least_x},
            {"sonic_height", measured.sonic_height},
            {"mass_error", mass_error},
            {"energy_error", energy_error},
            {"through_walls", static_cast<double>(through)},
            {"steps", static_cast<double>(counters.steps)},
            {"pairs", static_cast<double>(counters.pairs)},
            {"cpu_seconds", seconds, "s"}};
}

}  // namespace sph::godunov
