#include "chapters/01_kernel_interpolation/scenes/cost_measures.hpp"
#include "chapters/02_consistency/figures/figures.hpp"
#include "common/report/norms.hpp"

/// What accuracy costs. Times are of one thread, the best of several samples; the particles are sorted
/// beforehand, and each evaluation looks for its neighbours.
namespace sph::consistency {
namespace {

template <int d>
using K = QuinticSpline<d>;

template <int d, class... Listed>
double ns_a_point(report::Run& run, const ParticleSet& set) {
    InterpolationWithin<K<d>, Free, Listed...> cloud{
        Free{}, make_points<d>(set.arrangement, set.per_side, set.jitter, set.seed),
        set.h_over_dx / static_cast<double>(set.per_side), TestFunction<d>{}};
    const report::Timing timing = run.time([&] { report::keep(&cloud.estimate()); });
    return ns * timing.best / static_cast<double>(cloud.size());
}

/// Time of the scheme of that name; they are types.
template <int d>
double time_of(report::Run& run, const std::string& scheme, const ParticleSet& set) {
    if (scheme == "differences") return ns_a_point<d, DifferenceGradient>(run, set);
    if (scheme == "cspm") return ns_a_point<d, MatrixGradient<>>(run, set);
    if (scheme == "linear") return ns_a_point<d, LinearGradient<>>(run, set);
    return ns_a_point<d, LinearFit<>>(run, set);
}

struct Point {
    std::string label;
    double n = 0, error = 0, seconds = 0;
};
using Points = std::vector<Point>;

/// The sample of least time that reaches an error, as text.
std::string cheapest(const Points& points, double error) {
    const Point* best = nullptr;
    for (const Point& p : points) {
        if (p.error <= error && (best == nullptr || p.n < best->n)) best = &p;
    }
    return best == nullptr
               ? "–"
               : "N = " + report::fixed(best->n, 0) + ", " + report::timing(1e6 * best->seconds) + " µs";
}

template <int d>
std::vector<Points> cost_panel(report::Run& run, plot::Panel& panel, Arrangement arrangement,
                               const std::vector<std::size_t>& sizes) {
    std::vector<Points> all;
    const std::string particles = arrangement == Arrangement::even ? "even " : "jittered ";
    for (const auto& scheme : schemes<d>()) {
        if (scheme.name == "sph" || scheme.name == "by-axes") continue;
        Points points;
        plot::Values seconds, error;
        for (const std::size_t n : sizes) {
            ParticleSet set;
            set.arrangement = arrangement;
            set.per_side = n;
            set.seed = run.seed();
            const double count = to_dimension(d, static_cast<double>(n));
            const double time = time_of<d>(run, scheme.name, set) * count / ns;
            const double l2 = slope_error(estimate<d>(set, wave<d>()), scheme, Where::everywhere);
            const std::string method = particles + std::to_string(d) + "D " + scheme.name;
            run.result(method, static_cast<long>(count), "l2_slope", l2);
            run.result(method, static_cast<long>(count), "cpu_seconds", time, "s");
            points.push_back({scheme.label, count, l2, time});
            seconds.push_back(time);
            error.push_back(l2);
        }
        panel.curve(seconds, error, scheme_style(scheme));
        all.push_back(points);
    }
    Points competitor;
    plot::Values seconds, error;
    for (const std::size_t n : sizes) {
        if (d == 2 && arrangement != Arrangement::even) break;  // there is no lattice
        const Competitor c =
            d == 1 ? differences_1d(run, arrangement, n, 0.2).front() : differences_2d(run, n).front();
        const double count = to_dimension(d, static_cast<double>(n)), time = c.ns * count / ns;
        run.result(particles + std::to_string(d) + "D " + c.name, static_cast<long>(count), "l2_slope",
                   c.error);
        run.result(particles + std::to_string(d) + "D " + c.name, static_cast<long>(count), "cpu_seconds",
                   time, "s");
        competitor.push_back({c.label, count, c.error, time});
        seconds.push_back(time);
        error.push_back(c.error);
    }
    if (!competitor.empty()) {
        panel.curve(
            seconds, error,
            {.label = "finite differences", .colour = plot::Colour{0, 0, 0}, .marker = plot::Marker::cross});
    }
    all.push_back(competitor);
    return all;
}

}  // namespace

void cost(report::Run& run) {
    plot::Figure figure{"cost", 2, 2};
    const std::vector<std::size_t> line =
        run.quick() ? std::vector<std::size_t>{64, 256, 1024}
                    : std::vector<std::size_t>{32, 64, 128, 256, 512, 1024, 2048, 4096};
    const std::vector<std::size_t> plane = run.quick()
                                               ? std::vector<std::size_t>{24, 48}
                                               : std::vector<std::size_t>{16, 24, 32, 48, 64, 96, 128, 192};
    std::array<std::vector<Points>, 4> measured;
    const std::array<std::string, 4> titles{"even particles, 1D", "jittered particles, 1D",
                                            "even particles, 2D", "jittered particles, 2D"};
    for (std::size_t k = 0; k < 4; ++k) {
        plot::Panel& panel =
            figure.at(static_cast<int>(k / 2), static_cast<int>(k % 2)).log_log().titled(titles[k]);
        panel.labels("CPU time of all slopes [s]", k % 2 == 0 ? "relative $L$_{2} error of ∇$A$" : "");
        panel.legend.shown = k == 1;
        panel.legend.outside = true;
        const Arrangement arrangement = k % 2 == 0 ? Arrangement::even : Arrangement::jittered;
        measured[k] = k < 2 ? cost_panel<1>(run, panel, arrangement, line)
                            : cost_panel<2>(run, panel, arrangement, plane);
    }
    run.save(figure);
    report::Table table{{"error of ∇A, particles", "differences (2.14)", "CSPM", "linearly exact",
                         "fitted line", "finite differences"}};
    for (const auto& [bound, k] : {std::pair{0.05, 1}, {0.01, 1}, {0.001, 1}, {0.05, 3}, {0.02, 3}}) {
        std::vector<std::string> row{"≤ " + report::number(100 * bound, 1) + " %, " +
                                     titles[static_cast<std::size_t>(k)]};
        for (const Points& points : measured[static_cast<std::size_t>(k)])
            row.push_back(points.empty() ? "need a lattice" : cheapest(points, bound));
        table.row(row);
    }
    run.fill("cost", table.markdown());
}

void cost_of_schemes(report::Run& run) {
    plot::Figure figure{"cost-of-schemes"};
    plot::Panel& panel =
        figure.panel().titled("2D, quintic spline, one core").labels("$h$/d$x$", "CPU time a point [ns]");
    struct Curve {
        std::string label;
        std::function<double(const ParticleSet&)> time;
    };
    const std::vector<Curve> curves{
        {"value", [&](const ParticleSet& s) { return ns_a_point<2, Value>(run, s); }},
        {"CSPM value (92)", [&](const ParticleSet& s) { return ns_a_point<2, Shepard>(run, s); }},
        {"slope (2.14)", [&](const ParticleSet& s) { return ns_a_point<2, DifferenceGradient>(run, s); }},
        {"CSPM slope (94)", [&](const ParticleSet& s) { return ns_a_point<2, MatrixGradient<>>(run, s); }},
        {"linearly exact slope",
         [&](const ParticleSet& s) { return ns_a_point<2, LinearGradient<>>(run, s); }},
        {"fitted line: value and slope",
         [&](const ParticleSet& s) { return ns_a_point<2, LinearFit<>>(run, s); }},
        {"CSPM value and slope",
         [&](const ParticleSet& s) { return ns_a_point<2, Shepard, MatrixGradient<>>(run, s); }}};
    const plot::Values hs = run.quick() ? plot::Values{1, 1.2, 2} : plot::Values{1, 1.2, 1.5, 2};
    report::Table table{{"listed", "ns a point at h = 1.2 dx", "at h = 2 dx"}};
    std::size_t index = 0;
    for (const Curve& curve : curves) {
        plot::Values times;
        std::vector<std::string> row{curve.label};
        for (const double h : hs) {
            ParticleSet set;
            set.arrangement = Arrangement::jittered;
            set.per_side = 64;
            set.h_over_dx = h;
            times.push_back(curve.time(set));
            run.result(curve.label + " h=" + report::number(h, 2), 4096, "cpu_ns_per_point", times.back(),
                       "ns");
            if (h == 1.2 || h == 2) row.push_back(report::timing(times.back()));
        }
        table.row(row);
        panel.curve(hs, times,
                    {.label = curve.label, .colour = plot::cycle(index), .marker = plot::Marker::circle});
        ++index;
    }
    panel.legend.outside = true;
    run.save(figure);
    run.fill("cost-of-schemes", table.markdown());
    run.fill("price", report::timing(panel.curves[3].y[1] / panel.curves[2].y[1]));  // at h = 1.2 dx
    run.fill("price-at-2", report::timing(panel.curves[3].y.back() / panel.curves[2].y.back()));
}

}  // namespace sph::consistency
