#include <array>

#include "chapters/01_kernel_interpolation/scenes/cost_measures.hpp"
#include "chapters/01_kernel_interpolation/figures/figures.hpp"

/// What accuracy costs: error against measured CPU time, for every kernel and several h/dx, beside
/// differences.
namespace sph {
namespace {

/// One kernel at one h/dx in one of the panels.
struct Sample {
    std::string kernel;
    double h_over_dx = 0, pairs = 0, error = 0, ns = 0;
};
using Samples = std::vector<Sample>;

struct CostPanel {
    int row, column, dimension;
    Arrangement arrangement;
    std::string name, title;
};

template <class K>
Samples scan_h(report::Run& run, const CostPanel& which, std::size_t n) {
    const plot::Values all{0.8, 1.0, 1.2, 1.5, 2.0, 2.5, 3.0}, some{1.0, 1.2, 2.0};
    Samples samples;
    for (const double h : run.quick() ? some : all) {
        const Setting setting{std::string{K::name}, which.arrangement, n, h, 0.2, run.seed()};
        const double reach = K::support * h;
        const Sample sample{setting.kernel, h, K::dimension == 1 ? 2 * reach : pi * reach * reach,
                            errors_of<K::dimension>(setting).gradient,
                            ns_per_point<K, DifferenceGradient>(run, setting)};
        const std::string method = which.name + " " + sample.kernel + " h=" + report::number(h, 2);
        const auto count = static_cast<long>(to_dimension(K::dimension, n));
        run.result(method, count, "l2_gradient", sample.error);
        run.result(method, count, "cpu_ns_per_point", sample.ns, "ns");
        samples.push_back(sample);
    }
    return samples;
}

template <int d>
Samples cost_panel(report::Run& run, plot::Panel& panel, const CostPanel& which) {
    const std::size_t n = d == 1 ? 128 : 48;
    std::size_t index = 0;
    Samples samples;
    for_each_kernel<d>([&](auto kernel) {
        using K = decltype(kernel);
        plot::Values time, error;
        for (const Sample& sample : scan_h<K>(run, which, n)) {
            time.push_back(sample.ns);
            error.push_back(sample.error);
            samples.push_back(sample);
        }
        panel.curve(time, error, kernel_style(index++, kernel_label(K::name), true));
    });
    if (d == 2 && which.arrangement != Arrangement::even) return samples;  // differences need a lattice
    for (const Competitor& c :
         d == 1 ? differences_1d(run, which.arrangement, n, 0.2) : differences_2d(run, n)) {
        const bool fourth = c.name == "central-4";
        panel.points({c.ns}, {c.error},
                     {.label = fourth ? "" : "differences, 2nd order",
                      .colour = plot::Colour{0, 0, 0},
                      .marker = fourth ? plot::Marker::cross : plot::Marker::plus,
                      .marker_size = 8});
        if (fourth) panel.note(1.5 * c.ns, c.error, "differences, 4th order");
        run.result(which.name + " " + c.name, static_cast<long>(n), "l2_gradient", c.error);
        run.result(which.name + " " + c.name, static_cast<long>(n), "cpu_ns_per_point", c.ns, "ns");
        samples.push_back({c.name, 0, 0, c.error, c.ns});
    }
    return samples;
}

bool is_difference(const Sample& sample) {
    return sample.h_over_dx == 0;
}

/// "cubic 1.0 dx: 4, ≈36 ns": kernel, h, pairs and time a point.
std::string described(const Sample& s) {
    return s.kernel + " " + report::fixed(s.h_over_dx, 1) + " dx: " + report::fixed(s.pairs, 0) + ", " +
           report::timing(s.ns) + " ns";
}

/// The sample with the fewest pairs among those that reach `error`; pairs, unlike seconds, are the same
/// everywhere.
std::string cheapest(const Samples& samples, double error) {
    const Sample* best = nullptr;
    for (const Sample& s : samples) {
        if (is_difference(s) || s.error > error) continue;
        if (best == nullptr || s.pairs < best->pairs || (s.pairs == best->pairs && s.error < best->error))
            best = &s;
    }
    return best == nullptr ? "none" : described(*best);
}

std::string most_accurate(const Samples& samples) {
    const Sample* best = nullptr;
    for (const Sample& s : samples) {
        if (!is_difference(s) && (best == nullptr || s.error < best->error)) best = &s;
    }
    return "**" + report::number(best->error, 2) + "** " + described(*best);
}

std::string differences(const Samples& samples) {
    std::string text;
    for (const Sample& s : samples) {
        if (!is_difference(s)) continue;
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

/// At h = dx on even points the cubic spline reaches the next neighbours only, and (2.14) is the central
/// difference.
void fill_identity(report::Run& run, const Samples& even) {
    const auto find = [&](const std::string& kernel, double h) {
        return *std::find_if(even.begin(), even.end(),
                             [&](const Sample& s) { return s.kernel == kernel && s.h_over_dx == h; });
    };
    const Sample cubic = find("cubic", 1.0), central = find("central-2", 0);
    run.fill("cubic-at-dx", report::number(cubic.error, 9));
    run.fill("central-2", report::number(central.error, 9));
    run.fill("identity-price", report::timing(cubic.ns / central.ns));
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
        panel.labels("CPU time a point [ns]", which.column == 0 ? "relative $L$_{2} error of ∇$A$" : "");
        panel.legend.shown = k == 1;
        panel.legend.outside = true;
        samples[k] =
            which.dimension == 1 ? cost_panel<1>(run, panel, which) : cost_panel<2>(run, panel, which);
    }
    run.save(figure);
    run.fill("cost", answer(samples));
    fill_identity(run, samples[0]);
    fill_limits(run, samples[3]);
}

}  // namespace sph
