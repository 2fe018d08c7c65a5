#include <map>

#include "chapters/05_tensile_instability/scenes/elastic_wave.hpp"
#include "common/plot/method_looks.hpp"
#include "common/report/norms.hpp"

namespace sph::tensile {
namespace {

const std::vector<std::string> compared{"jaumann", "total-lagrangian"};

struct Series {
    plot::Values n, error;
    double order() const {
        const std::size_t last = n.size() - 1;
        return report::observed_order(n[last - 1], error[last - 1], n[last], error[last]);
    }
};

Series measure(report::Run& run, Polarisation polarisation, const SolidMethod& method) {
    Series series;
    for (const std::size_t n : run.sizes({16, 32}, {16, 32, 64, 128})) {
        const ElasticWaveScene scene{.polarisation = polarisation, .n = n, .threads = run.threads()};
        const ElasticWaveRun wave = run_elastic_wave(scene, method);
        run.record(method.name + " " + std::string{name_of(polarisation)}, n, wave.measured());
        series.n.push_back(static_cast<double>(n));
        series.error.push_back(wave.error);
    }
    return series;
}

}  // namespace

void elastic_waves(report::Run& run) {
    plot::Figure figure{"elastic-waves", 1, 2};
    figure.share_y = true;
    std::map<std::string, double> order, last;
    for (const Polarisation wave : {Polarisation::longitudinal, Polarisation::transverse}) {
        const bool longitudinal = wave == Polarisation::longitudinal;
        plot::Panel& panel = figure.at(0, longitudinal ? 0 : 1)
                                 .log_log()
                                 .titled(longitudinal ? "P wave, $c$_{l}" : "S wave, $c$_{t}")
                                 .labels("particles per wave length $N$", "relative $L$_{1} error of $v$");
        for (const SolidMethod& method : solid_methods().named(compared)) {
            const Series series = measure(run, wave, method);
            panel.curve(series.n, series.error, plot::look_of(method.name, method.label));
            const std::string key = std::string{name_of(wave)} + " " + method.name;
            order[key] = series.order();
            last[key] = series.error.back();
            run.record(key, static_cast<std::size_t>(series.n.back()), {{"rate_l1_v", series.order()}});
        }
        panel.slope(-2, 16, 128, 0.08, "order 2");
        panel.legend.shown = longitudinal;
    }
    run.save(figure);
    run.fill("lattice-matrix", report::fixed(lattice_matrix(1.5, 3)[0][0], 3));
    run.claim("elastic-waves-second-order", [&] {
        return order["p total-lagrangian"] > 1.95 && order["p total-lagrangian"] < 2.05 &&
               order["s total-lagrangian"] > 1.95 && order["s total-lagrangian"] < 2.05;
    });
    run.claim("elastic-waves-floor", [&] {
        return order["p jaumann"] < 0.5 && order["s jaumann"] < 0.5 &&
               last["p jaumann"] > 5 * last["p total-lagrangian"];
    });
}

}  // namespace sph::tensile
