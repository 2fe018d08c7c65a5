#include "chapters/02_consistency/figures/figures.hpp"

namespace sph::consistency {
namespace {

/// One kernel's rms defects over a series of jitters; the last ones are those of random particles.
struct Defects {
    plot::Values jitter, zeroth, first;
};

template <int d>
Defects measure(report::Run& run, const Options& options, const std::string& kernel, report::Table& table) {
    const plot::Values jitters = run.quick() ? plot::Values{0, 0.1, 0.3, 0.5}
                                             : plot::Values{0, 0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5};
    Defects all;
    const auto add = [&](Arrangement arrangement, double jitter, const std::string& name) {
        ParticleSet set = options.set(run);
        set.kernel = kernel;
        set.arrangement = arrangement;
        set.per_side = d == 1 ? 2000 : run.quick() ? 48 : 100;
        set.jitter = jitter;
        set.volumes = Volumes::equal;
        const MomentDefects defects = moment_defects<d>(set);
        const auto n = static_cast<long>(to_dimension(d, set.per_side));
        const std::string method = kernel + " " + std::to_string(d) + "D " + name;
        run.result(method, n, "rms_m0_defect", defects.m0);
        run.result(method, n, "rms_m1_over_h", defects.m1);
        run.result(method, n, "m2_defect", defects.m2);
        all.jitter.push_back(jitter);
        all.zeroth.push_back(defects.m0);
        all.first.push_back(defects.m1);
        const bool shown = jitter == 0 || jitter == 0.1 || jitter == 0.3;
        if (!shown) return;
        table.row({kernel + ", " + name, report::number(defects.m0, 2),
                   defects.m1 < 1e-12 ? "0" : report::number(defects.m1, 2), report::number(defects.m2, 2)});
    };
    for (const double jitter : jitters)
        add(jitter == 0 ? Arrangement::even : Arrangement::jittered, jitter,
            jitter == 0 ? "even" : "jitter " + report::number(jitter, 2) + " dx");
    add(Arrangement::random, 0, "random");
    return all;
}

template <int d>
void against_jitter(report::Run& run, plot::Panel& panel, const Options& options, report::Table& table) {
    constexpr double random_at = 0.6;
    std::size_t index = 0;
    for (const std::string kernel : {"cubic", "quintic"}) {
        Defects defects = measure<d>(run, options, kernel, table);
        const auto draw = [&](plot::Values values, const std::string& what, plot::Marker marker) {
            plot::Style style{.label = what + ", " + kernel,
                              .colour = plot::cycle(index++),
                              .marker = marker,
                              .filled = kernel == "cubic"};
            const double random = values.back();
            values.pop_back();
            plot::Values x{defects.jitter.begin(), defects.jitter.end() - 1};
            if (values.front() <
                1e-12) {  // the first moment of even particles is zero: no place on a log axis
                values.erase(values.begin());
                x.erase(x.begin());
            }
            panel.curve(x, values, style);
            style.label.clear();
            style.width = 0;
            panel.curve({random_at}, {random}, style);
        };
        draw(defects.zeroth, "$m$_{0} − 1", plot::Marker::circle);
        draw(defects.first, "$m$_{1}/$h$", plot::Marker::square);
    }
    panel.log_y().y_range(1e-5, 3).x_range(-0.02, 0.65);
    panel.labels("jitter [d$x$]", "rms defect, " + std::to_string(d) + "D");
    panel.x.ticks = {0, 0.1, 0.2, 0.3, 0.4, 0.5, random_at};
    panel.x.tick_names = {"0", "0.1", "0.2", "0.3", "0.4", "0.5", "random"};
    panel.legend.shown = d == 1;
}

/// Moments near the end of even particles, beside the integrals.
template <int d>
void against_distance(report::Run& run, plot::Panel& panel, const Options& options) {
    ParticleSet set = options.set(run);
    set.arrangement = Arrangement::even;
    set.volumes = Volumes::equal;
    set.per_side = d == 1 ? 200 : 60;
    plot::Values s, m0, m1, sum_s, sum_m0, sum_m1;
    for (const double distance : linear_space(0, 3.2, 65)) {
        const KernelAtTheEnd exact = integrals_at_the_end<d>(set.kernel, distance);
        s.push_back(distance);
        m0.push_back(exact.m0);
        m1.push_back(exact.m1);
    }
    double worst = 0;
    for (const double h_over_dx : {0.8, 1.2, 2.0}) {  // particles at several distances in units of h
        set.h_over_dx = h_over_dx;
        const AtTheEnd end = moments_at_the_end<d>(set);
        for (std::size_t i = 0; i < end.m0.size(); ++i) {
            sum_s.push_back(end.distance_over_h[i]);
            sum_m0.push_back(end.m0[i]);
            sum_m1.push_back(end.m1[i]);
            if (h_over_dx == 2.0)
                worst = std::max(worst,
                                 std::abs(end.m0[i] - integrals_at_the_end<d>(set.kernel, sum_s.back()).m0));
        }
        if (h_over_dx == 1.2) {
            run.result(set.kernel + " " + std::to_string(d) + "D first particle", 1, "m0_defect",
                       end.m0.front() - 1);
            run.result(set.kernel + " " + std::to_string(d) + "D first particle", 1, "m1_over_h",
                       end.m1.front());
            if (d == 1) {
                run.fill("end-m0", report::fixed(end.m0.front(), 2));
                run.fill("end-m1", report::fixed(end.m1.front(), 2));
            }
        }
    }
    run.result(set.kernel + " " + std::to_string(d) + "D h=2", 1, "linf_m0_sum_against_integral", worst,
               "absolute");
    panel.labels("distance from the end / $h$", "moments, " + std::to_string(d) + "D").x_range(0, 3.2);
    panel.curve(s, m0, {.label = "$m$_{0}, integral", .colour = plot::cycle(0)});
    panel.curve(s, m1, {.label = "$m$_{1}/$h$, integral", .colour = plot::cycle(1)});
    panel.points(sum_s, sum_m0,
                 {.label = "sums, even particles",
                  .colour = plot::cycle(0),
                  .marker = plot::Marker::circle,
                  .filled = false});
    panel.points(sum_s, sum_m1, {.colour = plot::cycle(1), .marker = plot::Marker::circle, .filled = false});
    panel.legend.shown = d == 1;
}

}  // namespace

void moments(report::Run& run, const Options& options) {
    plot::Figure figure{"moments", 2, 2};
    report::Table all{{"1D, h = " + report::number(options.h_over_dx, 2) + " dx", "rms of m₀ − 1",
                       "rms of m₁/h", "m₂/⟨x²⟩h² − 1"}};
    against_jitter<1>(
        run, figure.at(0, 0).titled("inside, $h$ = " + report::number(options.h_over_dx, 2) + " d$x$"),
        options, all);
    against_distance<1>(run, figure.at(0, 1).titled("at an end, " + kernel_label(options.kernel)), options);
    report::Table plane{{"2D", "rms of m₀ − 1", "rms of m₁/h", "m₂/⟨x²⟩h² − 1"}};
    against_jitter<2>(run, figure.at(1, 0), options, plane);
    against_distance<2>(run, figure.at(1, 1), options);
    run.save(figure);
    run.fill("moments", all.markdown());
    run.fill("moments-2d", plane.markdown());
}

}  // namespace sph::consistency
