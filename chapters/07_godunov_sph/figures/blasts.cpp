#include <algorithm>
#include <cmath>
#include <map>

#include "chapters/04_artificial_viscosity/scenes/noh_plane.hpp"
#include "chapters/04_artificial_viscosity/scenes/sedov_plane.hpp"
#include "chapters/07_godunov_sph/scenes/godunov_methods.hpp"
#include "chapters/07_godunov_sph/scenes/sedov.hpp"
#include "common/core/unstable.hpp"
#include "common/exact/noh.hpp"
#include "common/exact/sedov.hpp"
#include "common/plot/looks.hpp"
#include "common/report/comparison.hpp"

/// Shocks in the plane and in space. All runs with one thread, so that their CPU times compare.
namespace sph::godunov {
namespace {

constexpr double width = 2;  // of the blast's energy, in spacings

report::Comparison blast_table() {
    using namespace report;
    return {{"problem", "method"},
            {{"ρ %", "l1_rho", in_percent()},
             {"v %", "l1_v", in_percent()},
             {"shock", "shock", decimals(3)},
             {"peak / exact", "peak", digits(2)},
             {"CPU [s]", "cpu_seconds", time_in(1)}}};
}
template <int d>
report::Quantities blast_numbers(const BlastRun<d>& blast) {
    return {{"l1_rho", blast.l1_rho},
            {"l1_v", blast.l1_v},
            {"shock", blast.shock},
            {"peak", blast.peak},
            {"cpu_seconds", blast.seconds, "s"},
            {"energy_drift", blast.energy_drift}};
}
report::Quantities noh_numbers(const shocks::NohRun& noh) {
    return {{"l1_rho", noh.l1_rho},
            {"l1_v", noh.l1_v},
            {"shock", noh.shock},
            {"peak", noh.plateau / 16},
            {"cpu_seconds", noh.seconds, "s"}};
}

/// The particles of the lowest layer of the octant: a slice through the shell.
plot::Discs slice(const BlastRun<3>& blast, double layer) {
    plot::Discs discs{.name = "density", .diameter = 6.5, .bar = {.label = "ρ"}};
    for (std::size_t i = 0; i < blast.r.size(); ++i) {
        if (blast.x[2][i] >= layer) continue;
        discs.x.push_back(blast.x[0][i]), discs.y.push_back(blast.x[1][i]);
        discs.value.push_back(blast.rho[i]);
    }
    return discs;
}

class Blasts {
  public:
    explicit Blasts(report::Run& run) : run_{&run} {}

    void noh();
    void plane();
    void space();
    void finish();

  private:
    template <class Make>
    void attempt(const std::string& problem, const std::string& name, const std::string& label, std::size_t n,
                 Make&& make) {
        try {
            const report::Quantities numbers = make();
            table_.add(*run_, problem + " " + name, n, {problem, label}, numbers);
            l1_rho_[problem + " " + name] = report::value_of(numbers, "l1_rho");
            shock_[problem + " " + name] = report::value_of(numbers, "shock");
            seconds_[problem + " " + name] = report::value_of(numbers, "cpu_seconds");
        } catch (const Unstable&) {
            table_.add_words({problem, label, "stops"});
        }
    }

    report::Run* run_;
    report::Comparison table_ = blast_table();
    std::map<std::string, double> l1_rho_, shock_, seconds_;
    BlastRun<3> shell_, theirs_;
    double drift_ = 0;  // of energy, the largest of all Godunov runs
};

void Blasts::noh() {
    const shocks::NohScene scene{.n = run_->quick() ? 12UL : 40UL};
    std::vector<Method<2>> methods =
        plane_methods().named({"inutsuka", "first-order", "godunov", "geometric-volume"});
    methods.push_back(shocks::plane_methods()["alpha-beta"]);
    methods.push_back(shocks::plane_methods()["reconstructed"]);
    for (const Method<2>& method : methods)
        attempt("Noh", method.name, method.label, scene.n,
                [&] { return noh_numbers(run_noh(scene, method)); });
    attempt("Noh", "grid", "grid", scene.n, [&] { return noh_numbers(run_noh_grid(scene, scene.n)); });
}

void Blasts::plane() {
    const BlastScene scene{.blast_width = width, .n = run_->quick() ? 12UL : 36UL};
    std::vector<Method<2>> methods = plane_methods().named({"inutsuka", "godunov", "geometric-volume"});
    methods.push_back(shocks::plane_methods()["reconstructed"]);
    for (const Method<2>& method : methods)
        attempt("Sedov in the plane", method.name, method.label, scene.n, [&] {
            const BlastRun<2> blast = run_blast<2>(scene, method);
            drift_ = std::max(drift_, blast.energy_drift);
            return blast_numbers(blast);
        });
    attempt("Sedov in the plane", "grid", "grid", scene.n, [&] {
        const shocks::SedovRun blast = shocks::run_sedov_grid({.blast_width = width, .n = scene.n});
        return report::Quantities{{"l1_rho", blast.l1_rho},
                                  {"l1_v", blast.l1_v},
                                  {"shock", blast.shock_radius},
                                  {"peak", blast.peak},
                                  {"cpu_seconds", blast.seconds, "s"}};
    });
}

void Blasts::space() {
    const BlastScene scene{.blast_width = width, .n = run_->quick() ? 8UL : 20UL};
    std::vector<Method<3>> methods = space_methods().named({"godunov"});
    methods.push_back(reconstructed_in_space());
    for (const Method<3>& method : methods)
        attempt("Sedov in space", method.name, method.label, scene.n, [&] {
            const BlastRun<3> blast = run_blast<3>(scene, method);
            drift_ = std::max(drift_, blast.energy_drift);
            if (method.name == "godunov") shell_ = blast;
            if (method.name == "reconstructed") theirs_ = blast;
            return blast_numbers(blast);
        });
}

void Blasts::finish() {
    plot::Figure figure{"blasts", 1, 2};
    figure.panel_width = 400, figure.panel_height = 330;
    plot::Panel& map = figure.at(0, 0).titled("Sedov in space, a slice").labels("$x$", "$y$");
    map.x_range(0, 0.5).y_range(0, 0.5);
    map.equal_aspect = true;
    map.particles(slice(shell_, 0.5 / std::cbrt(static_cast<double>(shell_.r.size()))));
    plot::Panel& profile = figure.at(0, 1).labels("$r$", "ρ").x_range(0, 0.5);
    const auto dots = [&](const BlastRun<3>& blast, const plot::Style& look) {
        const Column weight(blast.r.size(), 1);
        const auto shells = shocks::ring_means(blast.r, blast.rho, weight, 0.0125, 0.5);
        profile.curve(shells.r, shells.value, look);
    };
    dots(shell_, space_methods()["godunov"].styled());
    plot::Style theirs = reconstructed_in_space().styled();
    theirs.filled = false, theirs.dash = plot::Dash::dashed;
    dots(theirs_, theirs);
    const exact::Sedov exact{3, 5.0 / 3, 1, 1};
    plot::draw_exact(profile, 0, 0.5, [&](double r) { return exact.at(r, shell_.time).rho; });
    run_->save(figure);
    run_->fill("blasts", table_.markdown());
    const auto error = [&](const char* name) { return l1_rho_.at(name); };
    run_->claim("blasts-paper", [&] { return l1_rho_.count("Noh inutsuka") == 0; });
    run_->claim("blasts-noh", [&] {
        return error("Noh godunov") < error("Noh reconstructed") &&
               error("Noh geometric-volume") < 0.75 * error("Noh reconstructed") &&
               error("Noh grid") < 0.75 * error("Noh geometric-volume");
    });
    run_->claim("blasts-order",
                [&] { return std::abs(error("Noh first-order") / error("Noh godunov") - 1) < 0.1; });
    run_->claim("blasts-geometric", [&] {
        return shock_.at("Sedov in the plane geometric-volume") < 0.39 &&
               error("Sedov in the plane geometric-volume") > 1.8 * error("Sedov in the plane godunov");
    });
    run_->claim("blasts-sedov", [&] {
        return error("Sedov in the plane godunov") < 0.85 * error("Sedov in the plane reconstructed") &&
               error("Sedov in the plane grid") < error("Sedov in the plane godunov") &&
               (run_->checking() || seconds_.at("Sedov in the plane godunov") >
                                        1.1 * seconds_.at("Sedov in the plane reconstructed"));
    });
    run_->claim("blasts-space", [&] {
        return std::abs(shock_.at("Sedov in space godunov") / 0.4 - 1) < 0.03 &&
               error("Sedov in space godunov") < 0.8 * error("Sedov in space reconstructed");
    });
    run_->claim("blasts-energy", [&] { return drift_ < 1e-12; });
}

}  // namespace

void blasts(report::Run& run) {
    Blasts all{run};
    all.noh();
    all.plane();
    all.space();
    all.finish();
}

}  // namespace sph::godunov
