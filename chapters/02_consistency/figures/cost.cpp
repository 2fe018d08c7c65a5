#include <array>
#include <cmath>

#include "chapters/01_kernel_interpolation/scenes/cost_measures.hpp"
#include "chapters/02_consistency/figures/figures.hpp"
#include "chapters/02_consistency/scenes/scheme_times.hpp"
#include "common/plot/looks.hpp"
#include "common/report/race.hpp"

/// What accuracy costs: error of the slope against CPU seconds over the number of particles.
namespace sph::consistency {
namespace {

using interpolation::differences_1d;
using interpolation::differences_2d;
using interpolation::ns;

template <int d>
std::size_t side_of(std::size_t n) {
    return d == 1 ? n : static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(n))));
}

template <int d>
report::Contestant contestant(report::Run& run, const Scheme<d>& scheme, Arrangement arrangement) {
    return {
        scheme.name, scheme.label, scheme_style(scheme), [=, &run](std::size_t n) {
            const ParticleSet set{.arrangement = arrangement, .per_side = side_of<d>(n), .seed = run.seed()};
            const double time = slope_ns_per_point<d>(run, scheme.name, set) / ns;
            return report::Lap{.error = slope_error(estimate<d>(set, wave<d>()), scheme, Where::everywhere),
                               .seconds = time * static_cast<double>(n)};
        }};
}

/// Finite differences of second order.
template <int d>
report::Contestant differences(report::Run& run, Arrangement arrangement) {
    const std::string name = arrangement == Arrangement::even ? "central-2" : "three-point";
    const std::string label = "finite differences";
    return {name, label, plot::competitor(label), [=, &run](std::size_t n) {
                const auto scheme = d == 1 ? differences_1d(run, arrangement, n, 0.2).front()
                                           : differences_2d(run, side_of<d>(n)).front();
                return report::Lap{.error = scheme.error, .seconds = scheme.ns / ns * static_cast<double>(n)};
            }};
}

std::vector<std::size_t> sizes(bool quick, int d) {
    if (d == 1)
        return quick ? std::vector<std::size_t>{64, 256, 1024}
                     : std::vector<std::size_t>{32, 64, 128, 256, 512, 1024, 2048, 4096};
    std::vector<std::size_t> squares =
        quick ? std::vector<std::size_t>{24, 48} : std::vector<std::size_t>{16, 24, 32, 48, 64, 96, 128, 192};
    for (std::size_t& n : squares) n *= n;
    return squares;
}

template <int d>
std::vector<report::Track> race_panel(report::Run& run, plot::Panel& panel, Arrangement arrangement) {
    const std::string particles = arrangement == Arrangement::even ? "even" : "jittered";
    const report::RaceCourse course{.name = particles + " " + std::to_string(d) + "D",
                                    .sizes = sizes(run.quick(), d),
                                    .quantity = "l2_slope",
                                    .repeats = 1};  // a lap's time is the best of several already
    std::vector<report::Contestant> contestants;
    for (const auto& scheme : schemes<d>()) {
        if (scheme.name != "sph" && scheme.name != "by-axes")
            contestants.push_back(contestant<d>(run, scheme, arrangement));
    }
    if (d == 1 || arrangement == Arrangement::even)  // elsewhere there is no lattice
        contestants.push_back(differences<d>(run, arrangement));
    auto tracks = report::race(run, course, contestants);
    report::draw_error_against_seconds(panel, tracks);
    return tracks;
}

/// The fewest particles that stay below the error, and their time.
std::string cheapest(const report::Track& track, double error) {
    const std::size_t k = track.first_below(error);
    if (k == track.n.size()) return report::never_reached;
    return "N = " + std::to_string(track.n[k]) + ", " + report::timing(1e6 * track.seconds[k]) + " µs";
}

const std::array<std::string, 4>& titles() {
    static const std::array<std::string, 4> all{"even particles, 1D", "jittered particles, 1D",
                                                "even particles, 2D", "jittered particles, 2D"};
    return all;
}

std::string answer(const std::array<std::vector<report::Track>, 4>& tracks) {
    report::Table table{{"error of ∇A, particles", "differences (1.12)", "CSPM", "linearly exact",
                         "fitted line", "finite differences"}};
    for (const auto& [bound, k] :
         {std::pair{0.05, 1UL}, {0.01, 1UL}, {0.001, 1UL}, {0.05, 3UL}, {0.02, 3UL}}) {
        std::vector<std::string> row{"≤ " + report::number(100 * bound, 1) + " %, " + titles()[k]};
        for (const report::Track& track : tracks[k]) row.push_back(cheapest(track, bound));
        if (k == 3) row.emplace_back("need a lattice");
        table.row(row);
    }
    return table.markdown();
}

}  // namespace

void cost(report::Run& run) {
    plot::Figure figure{"cost", 2, 2};
    std::array<std::vector<report::Track>, 4> tracks;
    for (std::size_t k = 0; k < 4; ++k) {
        plot::Panel& panel = figure.at(static_cast<int>(k / 2), static_cast<int>(k % 2)).log_log();
        panel.titled(titles()[k]);
        panel.labels("CPU time of all slopes [s]", k % 2 == 0 ? "relative $L$_{2} error of ∇$A$" : "");
        panel.legend = {.shown = k == 1, .outside = true};
        const Arrangement arrangement = k % 2 == 0 ? Arrangement::even : Arrangement::jittered;
        tracks[k] = k < 2 ? race_panel<1>(run, panel, arrangement) : race_panel<2>(run, panel, arrangement);
    }
    run.save(figure);
    run.fill("cost", answer(tracks));
    run.claim("differences-never", [&] {
        return tracks[1][0].first_below(0.01) == tracks[1][0].n.size() &&
               tracks[1][1].first_below(0.01) < tracks[1][1].n.size();
    });
    run.claim("grid-cheaper-1d", [&] {
        const report::Track &sum = tracks[1][1], &grid = tracks[1].back();
        return run.checking() ||
               sum.seconds[sum.first_below(1e-3)] > 50 * grid.seconds[grid.first_below(1e-3)];
    });
}

}  // namespace sph::consistency
