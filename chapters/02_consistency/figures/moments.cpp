#include <algorithm>
#include <cmath>

#include "chapters/02_consistency/figures/figures.hpp"
#include "chapters/02_consistency/scenes/defects.hpp"
#include "chapters/02_consistency/scenes/options.hpp"

namespace sph::consistency {
namespace {

/// One kernel's rms defects over a series of jitters; the last ones are those of random particles.
struct Defects {
    plot::Values jitter, zeroth, first;
};

template <int d>
Defects measure(report::Run& run, const ParticleSetOptions& options, report::Table& table) {
    const plot::Values jitters = run.quick() ? plot::Values{0, 0.1, 0.3, 0.5}
                                             : plot::Values{0, 0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5};
    Defects all;
    const auto add = [&](Arrangement arrangement, double jitter, const std::string& name) {
        ParticleSet set = options.set(arrangement, d == 1 ? 2000 : run.quick() ? 48 : 100, run);
        set.jitter = jitter;
        set.volumes = Volumes::equal;
        const MomentDefects defects = moment_defects<d>(set);
        run.record(options.kernel + " " + std::to_string(d) + "D " + name, to_dimension(d, set.per_side),
                   {{"rms_m0_defect", defects.m0}, {"rms_m1_over_h", defects.m1}, {"m2_defect", defects.m2}});
        all.jitter.push_back(jitter);
        all.zeroth.push_back(defects.m0);
        all.first.push_back(defects.m1);
        if (jitter != 0 && jitter != 0.1 && jitter != 0.3) return;
        table.row({options.kernel + ", " + name, report::number(defects.m0, 2),
                   defects.m1 < 1e-12 ? "0" : report::number(defects.m1, 2), report::number(defects.m2, 2)});
    };
    for (const double jitter : jitters)
        add(jitter == 0 ? Arrangement::even : Arrangement::jittered, jitter,
            jitter == 0 ? "even" : "jitter " + report::number(jitter, 2) + " dx");
    add(Arrangement::random, 0, "random");
    return all;
}

constexpr double random_at = 0.6;  // on the axis of jitters

/// A defect against jitter, and its value for random particles beside the line.
void draw(plot::Panel& panel, const plot::Values& jitter, const plot::Values& defect, plot::Style style) {
    plot::Values x{jitter.begin(), jitter.end() - 1}, y{defect.begin(), defect.end() - 1};
    if (y.front() < 1e-12) {  // the first moment of even particles is zero: no place on a log axis
        x.erase(x.begin());
        y.erase(y.begin());
    }
    panel.curve(x, y, style);
    style.label.clear();
    style.width = 0;
    panel.curve({random_at}, {defect.back()}, style);
}

template <int d>
void against_jitter(report::Run& run, plot::Panel& panel, double h_over_dx, report::Table& table) {
    std::size_t index = 0;
    for (const std::string kernel : {"cubic", "quintic"}) {
        ParticleSetOptions options;
        options.kernel = kernel;
        options.h_over_dx = h_over_dx;
        const Defects defects = measure<d>(run, options, table);
        const auto style = [&](const std::string& what, plot::Marker marker) {
            return plot::Style{.label = what + ", " + kernel,
                               .colour = plot::cycle(index++),
                               .marker = marker,
                               .filled = kernel == "cubic"};
        };
        draw(panel, defects.jitter, defects.zeroth, style("$m$_{0} − 1", plot::Marker::circle));
        draw(panel, defects.jitter, defects.first, style("$m$_{1}/$h$", plot::Marker::square));
    }
    panel.log_y().y_range(1e-5, 3).x_range(-0.02, 0.65);
    panel.labels("jitter [d$x$]", "rms defect, " + std::to_string(d) + "D");
    panel.x.ticks = {0, 0.1, 0.2, 0.3, 0.4, 0.5, random_at};
    panel.x.tick_names = {"0", "0.1", "0.2", "0.3", "0.4", "0.5", "random"};
    panel.legend.shown = d == 1;
}

/// The integrals over what an end leaves of the kernel, as lines.
template <int d>
void draw_integrals(plot::Panel& panel, const std::string& kernel) {
    plot::Values distance = linear_space(0, 3.2, 65), m0, m1;
    for (const double s : distance) {
        const KernelAtTheEnd exact = integrals_at_the_end<d>(kernel, s);
        m0.push_back(exact.m0);
        m1.push_back(exact.m1);
    }
    panel.labels("distance from the end / $h$", "moments, " + std::to_string(d) + "D").x_range(0, 3.2);
    panel.curve(distance, m0, {.label = "$m$_{0}, integral", .colour = plot::cycle(0)});
    panel.curve(distance, m1, {.label = "$m$_{1}/$h$, integral", .colour = plot::cycle(1)});
    panel.legend.shown = d == 1;
}

/// What the first particle sees at h = 1.2 dx, and how far the sums are from the integrals at h = 2 dx.
template <int d>
void record_end(report::Run& run, const std::string& kernel, double h_over_dx, const AtTheEnd& end) {
    const std::string name = kernel + " " + std::to_string(d) + "D ";
    if (h_over_dx == 1.2) {
        run.record(name + "first particle", 1,
                   {{"m0_defect", end.m0.front() - 1}, {"m1_over_h", end.m1.front()}});
        if (d == 2) return;
        run.fill("end-m0", report::fixed(end.m0.front(), 2));
        run.fill("end-m1", report::fixed(end.m1.front(), 2));
    } else if (h_over_dx == 2.0) {
        double worst = 0;
        for (std::size_t i = 0; i < end.m0.size(); ++i) {
            const double exact = integrals_at_the_end<d>(kernel, end.distance_over_h[i]).m0;
            worst = std::max(worst, std::abs(end.m0[i] - exact));
        }
        run.result(name + "h=2", 1, "linf_m0_sum_against_integral", worst, "absolute");
    }
}

/// Moments near the end of even particles, beside the integrals.
template <int d>
void against_distance(report::Run& run, plot::Panel& panel, const std::string& kernel) {
    draw_integrals<d>(panel, kernel);
    plot::Values s, m0, m1;
    for (const double h_over_dx : {0.8, 1.2, 2.0}) {  // particles at several distances in units of h
        const ParticleSet set{.kernel = kernel,
                              .per_side = d == 1 ? std::size_t{200} : std::size_t{60},
                              .h_over_dx = h_over_dx,
                              .volumes = Volumes::equal,
                              .threads = run.threads()};
        const AtTheEnd end = moments_at_the_end<d>(set);
        s.insert(s.end(), end.distance_over_h.begin(), end.distance_over_h.end());
        m0.insert(m0.end(), end.m0.begin(), end.m0.end());
        m1.insert(m1.end(), end.m1.begin(), end.m1.end());
        record_end<d>(run, kernel, h_over_dx, end);
    }
    panel.points(s, m0,
                 {.label = "sums, even particles",
                  .colour = plot::cycle(0),
                  .marker = plot::Marker::circle,
                  .filled = false});
    panel.points(s, m1, {.colour = plot::cycle(1), .marker = plot::Marker::circle, .filled = false});
}

/// rms of m0 - 1 in 1D at h = 1.2 dx.
double rms_of_m0(const report::Run& run, double jitter, std::size_t n = 2000) {
    ParticleSet set{.arrangement = jitter == 0 ? Arrangement::even : Arrangement::jittered,
                    .per_side = n,
                    .jitter = jitter,
                    .seed = run.seed(),
                    .volumes = Volumes::equal,
                    .threads = run.threads()};
    return moment_defects<1>(set).m0;
}

void say_of_disorder(report::Run& run) {
    const auto needs = report::Needs::any_run;
    run.claim(
        "a-fiftieth", [&] { return rms_of_m0(run, 0.02) > 100 * rms_of_m0(run, 0); }, needs);
    run.claim(
        "defect-grows-with-jitter",
        [&] {
            const double ratio = rms_of_m0(run, 0.2) / rms_of_m0(run, 0.1);
            return ratio > 1.8 && ratio < 2.2;
        },
        needs);
    run.claim(
        "defect-knows-no-n",
        [&] { return std::abs(rms_of_m0(run, 0.2, 500) / rms_of_m0(run, 0.2) - 1) < 0.15; }, needs);
}

class MomentsFigure {
  public:
    void declare(app::CommandLine& line) { options_.declare(line); }
    void run(report::Run& run) const {
        const std::string h = report::number(options_.h_over_dx, 2);
        plot::Figure figure{"moments", 2, 2};
        figure.at(0, 0).titled("inside, $h$ = " + h + " d$x$");
        figure.at(0, 1).titled("at an end, " + kernel_label(options_.kernel));
        report::Table line{{"1D, h = " + h + " dx", "rms of m₀ − 1", "rms of m₁/h", "m₂/⟨x²⟩ − 1"}};
        report::Table plane{{"2D", "rms of m₀ − 1", "rms of m₁/h", "m₂/⟨x²⟩ − 1"}};
        against_jitter<1>(run, figure.at(0, 0), options_.h_over_dx, line);
        against_distance<1>(run, figure.at(0, 1), options_.kernel);
        against_jitter<2>(run, figure.at(1, 0), options_.h_over_dx, plane);
        against_distance<2>(run, figure.at(1, 1), options_.kernel);
        run.save(figure);
        run.fill("moments", line.markdown());
        run.fill("moments-2d", plane.markdown());
        say_of_disorder(run);
    }

  private:
    KernelOptions options_;
};

}  // namespace

report::Task moments() {
    return MomentsFigure{};
}

}  // namespace sph::consistency
