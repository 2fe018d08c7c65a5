#include <algorithm>
#include <array>
#include <functional>

#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/01_kernel_interpolation/kernels.hpp"
#include "chapters/01_kernel_interpolation/scenes/cost_measures.hpp"
#include "common/plot/looks.hpp"

/// What accuracy costs: error against measured CPU time, for every kernel and several h/dx, beside
/// differences.
namespace sph::interpolation {
namespace {

/// One kernel at one h/dx, or a difference scheme, in one of the panels.
struct Sample {
    std::string kernel;
    double h_over_dx = 0, pairs = 0, error = 0, ns = 0;
    bool is_difference() const { return h_over_dx == 0; }
};
using Samples = std::vector<Sample>;

struct CostPanel {
    int row, column, dimension;
    Arrangement arrangement;
    std::string name, title;
};

template <int d>
Samples scan_h(report::Run& run, const CostPanel& which, const std::string& kernel, double support,
               std::size_t n) {
    const plot::Values all{0.8, 1.0, 1.2, 1.5, 2.0, 2.5, 3.0}, some{1.0, 1.2, 2.0};
    Samples samples;
    for (const double h_over_dx : run.quick() ? some : all) {
        const Setting setting{kernel, which.arrangement, n, h_over_dx, 0.2, run.seed()};
        const double reach = support * h_over_dx;
        const Sample sample{kernel, h_over_dx, d == 1 ? 2 * reach : pi * reach * reach,
                            errors_of<d>(setting).gradient, gradient_ns_per_point<d>(run, setting)};
        run.record(which.name + " " + kernel + " h=" + report::number(h_over_dx, 2), to_dimension(d, n),
                   {{"l2_gradient", sample.error}, {"cpu_ns_per_point", sample.ns, "ns"}});
        samples.push_back(sample);
    }
    return samples;
}

/// Finite differences where there is a lattice or an order of the points.
void add_differences(report::Run& run, plot::Panel& panel, const CostPanel& which, std::size_t n,
                     Samples& samples) {
    if (which.dimension == 2 && which.arrangement != Arrangement::even) return;
    for (const MeasuredDifferences& c :
         which.dimension == 1 ? differences_1d(run, which.arrangement, n, 0.2) : differences_2d(run, n)) {
        const bool fourth = c.name == "central-4";
        plot::Style style =
            fourth ? plot::competitor("") : plot::competitor("differences, 2nd order", plot::Marker::plus);
        style.marker_size = 8;
        panel.points({c.ns}, {c.error}, style);
        if (fourth) panel.note(1.5 * c.ns, c.error, "differences, 4th order");
        run.record(which.name + " " + c.name, n,
                   {{"l2_gradient", c.error}, {"cpu_ns_per_point", c.ns, "ns"}});
        samples.push_back({c.name, 0, 0, c.error, c.ns});
    }
}

template <int d>
Samples cost_panel(report::Run& run, plot::Panel& panel, const CostPanel& which) {
    const std::size_t n = d == 1 ? 128 : 48;
    std::size_t index = 0;
    Samples samples;
    for_each_kernel<d>([&](const auto& kernel) {
        const std::string name{kernel.name};
        plot::Values time, error;
        for (const Sample& sample : scan_h<d>(run, which, name, kernel.support, n)) {
            time.push_back(sample.ns);
            error.push_back(sample.error);
            samples.push_back(sample);
        }
        panel.curve(time, error, told_style(index++, kernel_label(name), true));
    });
    add_differences(run, panel, which, n, samples);
    return samples;
}

/// "cubic 1.0 dx: 4, ≈36 ns": kernel, h, pairs and time a point.
std::string described(const Sample& s) {
    return s.kernel + " " + report::fixed(s.h_over_dx, 1) + " dx: " + report::fixed(s.pairs, 0) + ", " +
           report::timing(s.ns) + " ns";
}

/// The sample with the fewest pairs among those that reach `error`, or null; pairs, unlike seconds, are the
/// same everywhere.
const Sample* fewest_pairs(const Samples& samples, double error) {
    const Sample* best = nullptr;
    for (const Sample& s : samples) {
        if (s.is_difference() || s.error > error) continue;
        if (best == nullptr || s.pairs < best->pairs || (s.pairs == best->pairs && s.error < best->error))
            best = &s;
    }
    return best;
}
std::string cheapest(const Samples& samples, double error) {
    const Sample* best = fewest_pairs(samples, error);
    return best == nullptr ? "none" : described(*best);
}

std::string most_accurate(const Samples& samples) {
    const Sample* best = nullptr;
    for (const Sample& s : samples) {
        if (!s.is_difference() && (best == nullptr || s.error < best->error)) best = &s;
    }
    if (best == nullptr) return "none";
    return "**" + report::number(best->error, 2) + "** " + described(*best);
}

std::string differences(const Samples& samples) {
    std::string text;
    for (const Sample& s : samples) {
        if (!s.is_difference()) continue;
        text += (text.empty() ? "" : "; ") + s.kernel + ": " + report::number(s.error, 2) + ", " +
                report::timing(s.ns) + " ns";
    }
    return text.empty() ? "need a lattice" : text;
}

/// The table that answers the chapter's question about cost: rows are error bounds, columns the four panels.
std::string answer(const std::array<Samples, 4>& samples) {
    report::Table table{{"error", "even, 1D", "jittered, 1D", "even, 2D", "jittered, 2D"}};
    const auto row = [&](const std::string& name, const auto& cell) {
        table.row({name, cell(samples[0]), cell(samples[1]), cell(samples[2]), cell(samples[3])});
    };
    for (const double bound : {0.05, 0.025, 0.01, 0.001}) {
        row("≤ " + report::fixed(100 * bound, 1) + " %",
            [&](const Samples& s) { return cheapest(s, bound); });
    }
    row("the smallest", most_accurate);
    row("finite differences", differences);
    return table.markdown();
}

/// The same for the plane alone, cell by cell.
std::string plane_only(const std::array<Samples, 4>& samples) {
    report::Table table{
        {"error", "even: kernel, h/dx", "pairs", "ns", "jittered: kernel, h/dx", "pairs", "ns"}};
    for (const double bound : {0.05, 0.025, 0.01, 0.001}) {
        std::vector<std::string> cells{"≤ " + report::fixed(100 * bound, 1) + " %"};
        for (const std::size_t panel : {std::size_t{2}, std::size_t{3}}) {
            const Sample* best = fewest_pairs(samples[panel], bound);
            if (best == nullptr) {
                cells.insert(cells.end(), {"none", "", ""});
                continue;
            }
            cells.insert(cells.end(), {kernel_label(best->kernel) + ", " + report::fixed(best->h_over_dx, 1),
                                       report::fixed(best->pairs, 0), report::timing(best->ns)});
        }
        table.row(cells);
    }
    return table.markdown();
}

double smallest(const Samples& samples, const std::function<bool(const Sample&)>& counts) {
    double least = 1e300;
    for (const Sample& s : samples) {
        if (counts(s)) least = std::min(least, s.error);
    }
    return least;
}

void say_of_costs(report::Run& run, const std::array<Samples, 4>& samples) {
    const Samples &line = samples[0], &plane = samples[2], &jittered = samples[3];
    const auto of_sums = [](const Sample& s) { return !s.is_difference(); };
    run.claim("differences-win", [&] {
        const auto central =
            std::find_if(line.begin(), line.end(), [](const Sample& s) { return s.kernel == "central-2"; });
        return std::all_of(line.begin(), line.end(), [&](const Sample& s) {
            return run.checking() || s.is_difference() || s.error > 1.001 * central->error ||
                   s.ns > 50 * central->ns;
        });
    });
    run.claim("order-is-enough", [&] {
        const Samples& disordered = samples[1];
        const auto three_point = std::find_if(disordered.begin(), disordered.end(),
                                              [](const Sample& s) { return s.is_difference(); });
        return std::all_of(disordered.begin(), disordered.end(), [&](const Sample& s) {
            return s.is_difference() ||
                   (s.error > three_point->error && (run.checking() || s.ns > three_point->ns));
        });
    });
    run.claim("super-gaussian-on-even", [&] {
        const auto others = [&](const Sample& s) { return of_sums(s) && s.kernel != "super-gaussian"; };
        return smallest(plane, others) > 3 * smallest(plane, of_sums) &&
               smallest(line, others) > 3 * smallest(line, of_sums);
    });
    run.claim("per-cents-on-jittered",
              [&] { return smallest(jittered, of_sums) > 0.01 && smallest(jittered, of_sums) < 0.03; });
}

/// At h = dx on even points the cubic spline reaches the next neighbours only, and (2.14) is the central
/// difference.
void fill_identity(report::Run& run, const Samples& even) {
    const auto find = [&](const std::string& kernel, double h_over_dx) {
        return *std::find_if(even.begin(), even.end(),
                             [&](const Sample& s) { return s.kernel == kernel && s.h_over_dx == h_over_dx; });
    };
    const Sample cubic = find("cubic", 1.0), central = find("central-2", 0);
    run.fill("cubic-at-dx", report::number(cubic.error, 9));
    run.fill("central-2", report::number(central.error, 9));
    run.fill("identity-price", report::timing(cubic.ns / central.ns));
    run.claim(
        "cubic-is-central", [=] { return std::abs(cubic.error - central.error) < 1e-9 * central.error; },
        report::Needs::any_run);
}

/// What every kernel of second order can reach, over all h/dx: the smallest errors of the best and the worst
/// kernel.
void fill_limits(report::Run& run, const Samples& jittered) {
    double low = 1e300, high = 0;
    for (const std::string& kernel : kernel_names()) {
        if (kernel == "super-gaussian") continue;
        double best = 1e300;
        for (const Sample& s : jittered) {
            if (s.kernel == kernel) best = std::min(best, s.error);
        }
        low = std::min(low, best);
        high = std::max(high, best);
    }
    run.fill("second-order-limits", report::fixed(100 * low, 1) + " to " + report::fixed(100 * high, 1));
}

}  // namespace

void cost(report::Run& run) {
    plot::Figure figure{"cost", 2, 2};
    const std::array<CostPanel, 4> panels{
        {{0, 0, 1, Arrangement::even, "even-1d", "even particles, 1D"},
         {0, 1, 1, Arrangement::jittered, "jittered-1d", "jittered particles, 1D"},
         {1, 0, 2, Arrangement::even, "even-2d", "even particles, 2D"},
         {1, 1, 2, Arrangement::jittered, "jittered-2d", "jittered particles, 2D"}}};
    std::array<Samples, 4> samples;
    for (std::size_t k = 0; k < panels.size(); ++k) {
        const CostPanel& which = panels[k];
        plot::Panel& panel = figure.at(which.row, which.column).log_log().titled(which.title);
        panel.labels("CPU time per point [ns]", which.column == 0 ? "relative $L$_{2} error of ∇$A$" : "");
        panel.legend.shown = k == 1;
        panel.legend.outside = true;
        samples[k] =
            which.dimension == 1 ? cost_panel<1>(run, panel, which) : cost_panel<2>(run, panel, which);
    }
    run.save(figure);
    run.fill("all-cost", answer(samples));
    run.fill("cost", plane_only(samples));
    say_of_costs(run, samples);
    fill_identity(run, samples[0]);
    fill_limits(run, samples[3]);
}

}  // namespace sph::interpolation
