#include "chapters/07_godunov_sph/scenes/hamiltonian.hpp"

#include "common/plot/looks.hpp"
#include "common/plot/method_looks.hpp"
#include "common/report/chapter.hpp"

namespace sph::godunov {

void hamiltonian(report::Run& run) {
    plot::Values steps, integral, cubic;
    for (const long count : {64L, 128L, 256L, 512L, 1024L}) {
        if (run.quick() && count > 128) break;
        const WaveWithoutRiemann scene{.steps = count};
        steps.push_back(static_cast<double>(scene.n) / static_cast<double>(count));
        integral.push_back(energy_change(scene, PairForce::integral));
        cubic.push_back(energy_change(scene, PairForce::cubic));
        run.record("integral", count, {{"energy_change", integral.back()}});
        run.record("pairs with V cubic", count, {{"energy_change", cubic.back()}});
    }
    plot::Figure figure{"hamiltonian", 1, 1};
    figure.panel_width = 520;
    plot::Panel& panel =
        figure.at(0, 0).log_log().labels("$dt$ [d$x$/$c$_{s}]", "largest change of the energy");
    panel.curve(steps, integral, plot::competitor("the integral (7.4)"));
    panel.curve(steps, cubic, plot::look_of("inutsuka", "(7.9), V cubic, mean of both pressures"));
    panel.slope(2, 0.06, 0.3, 8e-6, "order 2");
    panel.y_range(3e-6, 0.5);
    run.save(figure);
    run.fill("hamiltonian-floor", report::number(cubic.back(), 1));
    run.claim("hamiltonian", [&] {
        const std::size_t last = integral.size() - 1;
        for (std::size_t k = 0; k < last; ++k) {
            const double ratio = integral[k] / integral[k + 1];
            if (!(ratio > 3.8 && ratio < 4.3)) return false;
        }
        return cubic[last] > 10 * integral[last] && cubic[last - 1] < 1.5 * cubic[last];
    });
}

}  // namespace sph::godunov
