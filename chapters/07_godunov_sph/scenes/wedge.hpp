#pragma once
#include "chapters/07_godunov_sph/scenes/channel_flow.hpp"
#include "chapters/07_godunov_sph/scenes/open_gas.hpp"
#include "common/report/chapter.hpp"

/// The wedge in a channel (Inutsuka 2002, section 4.3), by particles and by finite volumes.
namespace sph::godunov {

struct WedgeScene {
    WedgeChannel channel{};
    std::size_t cells = 32;  ///< particles across the stream that enters, and cells of the means
    double times = 2.75;  ///< how often the stream passes through the channel's length; means: the last third
    double courant = 0.45;
    bool mirrors = true;  ///< whether images stand behind the walls; without them nothing holds the gas
    int threads = 1;
    std::function<void(double share)> progress{};

    double end() const { return times * (channel.end - channel.begin) / channel.mach; }
};

struct WedgeRun {
    ChannelFlow flow;  ///< mean over the last third of the time
    Measured measured;
    Columns<2> x, v;  ///< of the particles, at the end
    Column rho, p, mach;
    double mass_error = 0;    ///< mass that entered, less what left and what is more; over what was there
    double energy_error = 0;  ///< the same of energy, with the work of the gas that pushes from behind
    double entered = 0, left = 0;  ///< masses
    long through = 0;              ///< particles that have been behind a wall, each once a step
    Counters counters;
    double seconds = 0;  ///< CPU time of the steps

    report::Quantities quantities() const;
};
/// Throws Unstable where the run leaves physics, or where a shock has come to the entry; std::domain_error
/// for a wedge from which the shock is detached.
WedgeRun run_wedge(const WedgeScene& scene, const ChannelMethod& method);

/// The same flow by finite volumes: 3 n times n cells, from a coarser solution if there is one.
struct WedgeGrid {
    exact::FiniteVolumeChannel solver;
    ChannelFlow flow;  ///< at the end
    Measured measured;
    double seconds = 0;
};
WedgeGrid run_wedge_grid(const WedgeScene& scene);
/// Twice as fine as `coarse`, from its flow on, for a sixth of the time of a run.
WedgeGrid refined(const WedgeScene& scene, const WedgeGrid& coarse);

}  // namespace sph::godunov
