#include "chapters/05_tensile_instability/scenes/regularisation.hpp"

#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "chapters/05_tensile_instability/figures/kernel_looks.hpp"
#include "chapters/05_tensile_instability/scenes/lattice_growth.hpp"
#include "common/report/chapter.hpp"

namespace sph::tensile {
namespace {

constexpr double P = 0.2;

double neighbours_of(const std::string& kernel, double h) {
    return pi * square(AnyKernel<2>{kernel}.support * h);
}

/// Fastest growth against the number of neighbours, pi (support h/dx)^2.
void draw_kernel(plot::Panel& panel, const std::string& kernel, int points) {
    plot::Values neighbours, rate;
    for (int n = 0; n <= points; ++n) {
        const double count = 12 + (120.0 - 12) * n / points;
        const double h = std::sqrt(count / pi) / AnyKernel<2>{kernel}.support;
        neighbours.push_back(count);
        rate.push_back(growth_on_grid<2>(named_lattice<2>(kernel, h), isotropic<2>(P), 24));
    }
    panel.curve(neighbours, rate, plot::line(look_of_kernel(kernel, kernel)));
}
double largest_beyond(const std::string& kernel, double least_neighbours) {
    double most = 0;
    for (double h = 0.9; neighbours_of(kernel, h) < 200; h += 0.05) {
        if (neighbours_of(kernel, h) < least_neighbours) continue;
        most = std::max(most, growth_on_grid<2>(named_lattice<2>(kernel, h), isotropic<2>(P), 24));
    }
    return most;
}

}  // namespace

void pairing(report::Run& run) {
    plot::Figure figure{"pairing", 1, 2};
    plot::Panel& left = figure.at(0, 0)
                            .titled("five kernels, $P$ = 0.2")
                            .labels("neighbours in the support", "fastest growth / ($c$/d$x$)");
    for (const std::string kernel : {"cubic", "quintic", "wendland-c2", "wendland-c4", "wendland-c6"})
        draw_kernel(left, kernel, run.quick() ? 40 : 120);
    plot::Panel& right =
        figure.at(0, 1).titled("cubic spline, $P$ = 0.2").labels("$h$ / d$x$", "growth, and distance / d$x$");
    plot::Values h_line, rate, h_dots, nearest;
    for (int n = 0; n <= 50; ++n) {
        h_line.push_back(1.1 + 0.01 * n);
        rate.push_back(growth_on_grid<2>(named_lattice<2>("cubic", h_line.back()), isotropic<2>(P), 24));
    }
    for (const double h :
         run.quick() ? std::vector{1.2, 1.5} : std::vector{1.1, 1.2, 1.3, 1.35, 1.4, 1.5, 1.6}) {
        Disorder scene{.time = 60};
        scene.box.h_over_dx = h;
        scene.box.threads = run.threads();
        const DisorderRun one = run_disorder(scene);
        h_dots.push_back(h);
        nearest.push_back(one.nearest);
        run.record("cubic h/dx = " + report::number(h, 3), scene.box.per_side,
                   {{"nearest", one.nearest, "dx"}});
    }
    right.curve(h_line, rate, {.label = "growth, predicted", .colour = plot::cycle(0)});
    right.points(h_dots, nearest,
                 {.label = "nearest pair at $t$ = 60 d$x$/$c$",
                  .colour = plot::cycle(1),
                  .marker = plot::Marker::circle});
    run.save(figure);
    double first = 0;
    for (std::size_t n = 0; n < rate.size() && first == 0; ++n) first = rate[n] > 0 ? h_line[n] : 0;
    run.fill("pairing-first-h", report::fixed(first, 2));
    const auto worst_wendland =
        std::max({largest_beyond("wendland-c2", 45), largest_beyond("wendland-c4", 60),
                  largest_beyond("wendland-c6", 80)});
    run.record("wendland with many neighbours", 1, {{"growth", worst_wendland, "c/dx"}});
    run.record("cubic with many neighbours", 1, {{"growth", largest_beyond("cubic", 45), "c/dx"}});
    run.claim(
        "pairing-wendland", [&] { return worst_wendland < 0.1 * largest_beyond("cubic", 45); },
        report::Needs::any_run);
    run.claim("pairing-measured", [&] {
        for (std::size_t n = 0; n < h_dots.size(); ++n)
            if ((h_dots[n] < first) != (nearest[n] > 0.8)) return false;
        return true;
    });
}

}  // namespace sph::tensile
