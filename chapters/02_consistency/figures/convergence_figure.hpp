#pragma once
#include <algorithm>
#include <cmath>
#include <map>

#include "chapters/02_consistency/figures/figures.hpp"
#include "chapters/02_consistency/scenes/options.hpp"
#include "common/report/norms.hpp"

namespace sph::consistency {

/// Errors of values and slopes by every scheme against N in d dimensions, over particles inside: the figures
/// convergence and convergence-2d.
template <int d>
class ConvergenceFigure {
  public:
    explicit ConvergenceFigure(std::string name) : name_{std::move(name)} {}
    void declare(app::CommandLine& line) { options_.declare(line); }
    void run(report::Run& run) const;

  private:
    /// One scheme's errors over the number of particles along a side.
    struct Curves {
        plot::Values value, slope, slope_with_ends;
    };
    std::vector<Curves> follow(report::Run& run, Arrangement arrangement,
                               const std::vector<std::size_t>& sizes) const;
    void draw_column(report::Run& run, plot::Figure& figure, int column, const plot::Values& n,
                     const std::vector<Curves>& curves, const std::string& arrangement,
                     std::vector<std::vector<std::string>>& rows) const;
    /// The story's table, and what the text says of orders.
    void say(report::Run& run, const plot::Values& n,
             const std::map<std::string, std::vector<Curves>>& of) const;
    static std::string method(const Scheme<d>& scheme, const std::string& arrangement) {
        return scheme.name + " " + std::to_string(d) + "D " + arrangement;
    }

    std::string name_;
    ParticleSetOptions options_;
};

namespace convergence_detail {

/// The order over the last half of the resolutions.
inline double late_order(const plot::Values& n, const plot::Values& error) {
    const std::size_t last = n.size() - 1, middle = last / 2;
    return report::observed_order(n[middle], error[middle], n[last], error[last]);
}

/// The error at the highest resolution, and the order over the last half of the resolutions.
inline std::string with_order(const plot::Values& n, const plot::Values& error) {
    const std::size_t last = n.size() - 1;
    return report::number(error[last], 2) + " [" + report::fixed(late_order(n, error), 1) + "]";
}

/// Sets of particles over which errors are averaged, for a smooth curve.
inline int sets_of(Arrangement arrangement, std::size_t n, int d) {
    if (arrangement == Arrangement::even) return 1;
    return d == 1 ? 8 : n < 128 ? 4 : 1;
}

inline std::vector<std::size_t> sizes(bool quick, int d) {
    if (d == 1)
        return quick ? std::vector<std::size_t>{64, 128, 256, 512}
                     : std::vector<std::size_t>{64, 128, 256, 512, 1024, 2048, 4096};
    return quick ? std::vector<std::size_t>{24, 32, 48}
                 : std::vector<std::size_t>{24, 32, 48, 64, 96, 128, 192, 256};
}

}  // namespace convergence_detail

template <int d>
auto ConvergenceFigure<d>::follow(report::Run& run, Arrangement arrangement,
                                  const std::vector<std::size_t>& sizes) const -> std::vector<Curves> {
    const auto all = schemes<d>();
    std::vector<Curves> curves(all.size());
    for (const std::size_t n : sizes) {
        const int sets = convergence_detail::sets_of(arrangement, n, d);
        ParticleSet set = options_.set(arrangement, n, run);
        std::vector<double> value(all.size()), slope(all.size()), with_ends(all.size());
        for (int s = 0; s < sets; ++s, ++set.seed) {
            const auto e = estimate<d>(set, wave<d>());
            for (std::size_t k = 0; k < all.size(); ++k) {
                if (all[k].value) value[k] += square(value_error(e, all[k], Where::inside)) / sets;
                slope[k] += square(slope_error(e, all[k], Where::inside)) / sets;
                with_ends[k] += square(slope_error(e, all[k], Where::everywhere)) / sets;
            }
        }
        for (std::size_t k = 0; k < all.size(); ++k) {
            curves[k].value.push_back(std::sqrt(value[k]));
            curves[k].slope.push_back(std::sqrt(slope[k]));
            curves[k].slope_with_ends.push_back(std::sqrt(with_ends[k]));
            const std::string name =
                method(all[k], arrangement_names()[static_cast<std::size_t>(arrangement)]);
            if (all[k].value) run.record(name, n, {{"l2_f", curves[k].value.back()}});
            run.record(name, n,
                       {{"l2_slope", curves[k].slope.back()},
                        {"l2_slope_with_ends", curves[k].slope_with_ends.back()}});
        }
    }
    return curves;
}

template <int d>
void ConvergenceFigure<d>::draw_column(report::Run& run, plot::Figure& figure, int column,
                                       const plot::Values& n, const std::vector<Curves>& curves,
                                       const std::string& arrangement,
                                       std::vector<std::vector<std::string>>& rows) const {
    using convergence_detail::with_order;
    const std::string axis = d == 1 ? "particles $N$" : "particles along a side";
    plot::Panel& top = figure.at(0, column).log_log().titled(arrangement);
    plot::Panel& bottom = figure.at(1, column).log_log();
    top.labels(axis, column == 0 ? "rel. $L$_{2} error of $A$" : "");
    bottom.labels(axis, column == 0 ? "rel. $L$_{2} error of ∇$A$" : "");
    top.legend.shown = false;
    bottom.legend.shown = column == 2;
    bottom.legend.outside = true;
    const auto all = schemes<d>();
    for (std::size_t k = 0; k < all.size(); ++k) {
        const auto& [value, slope, slope_with_ends] = curves[k];
        const auto last = static_cast<std::size_t>(n.back());
        const std::string name = method(all[k], arrangement);
        if (rows[k].empty()) rows[k].push_back(all[k].label);
        if (all[k].value) {
            top.curve(n, value, scheme_style(all[k]));
            run.record(name, last, {{"rate_f", report::fitted_order(n, value)}});
        }
        bottom.curve(n, slope, scheme_style(all[k]));
        run.record(name, last,
                   {{"rate_slope", report::fitted_order(n, slope)},
                    {"rate_slope_with_ends", report::fitted_order(n, slope_with_ends)}});
        rows[k].push_back(all[k].value ? with_order(n, value) : "");
        rows[k].push_back(with_order(n, slope));
        if (arrangement == "jittered") rows[k].push_back(with_order(n, slope_with_ends));
    }
}

template <int d>
void ConvergenceFigure<d>::run(report::Run& run) const {
    plot::Figure figure{name_, 2, 3};
    figure.panel_width = 310;
    figure.panel_height = 260;
    const auto sizes = convergence_detail::sizes(run.quick(), d);
    const plot::Values n{sizes.begin(), sizes.end()};
    std::vector<std::vector<std::string>> rows(schemes<d>().size());
    int column = 0;
    std::map<std::string, std::vector<Curves>> all;
    for (const std::string& arrangement : arrangement_names()) {
        auto curves = follow(run, arrangement_named(arrangement), sizes);
        draw_column(run, figure, column++, n, curves, arrangement, rows);
        all.emplace(arrangement, std::move(curves));
    }
    report::Table table{
        {std::to_string(d) + "D", "even: A", "∇A", "jittered: A", "∇A", "∇A, ends too", "random: A", "∇A"}};
    for (const auto& row : rows) table.row(row);
    run.save(figure);
    run.fill("all-" + name_, table.markdown());
    say(run, n, all);
}

template <int d>
void ConvergenceFigure<d>::say(report::Run& run, const plot::Values& n,
                               const std::map<std::string, std::vector<Curves>>& of) const {
    const auto all = schemes<d>();
    const auto named = [&](const std::string& arrangement, const std::string& scheme) -> const Curves& {
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const Scheme<d>& s) { return s.name == scheme; });
        return of.at(arrangement)[static_cast<std::size_t>(found - all.begin())];
    };
    const auto value = [&](const char* arrangement, const char* scheme) {
        return convergence_detail::late_order(n, named(arrangement, scheme).value);
    };
    const auto slope = [&](const char* arrangement, const char* scheme) {
        return convergence_detail::late_order(n, named(arrangement, scheme).slope);
    };
    if constexpr (d == 1) {
        report::Table story{{"1D", "A: even", "A: jittered", "∇A: even", "∇A: jittered"}};
        for (const Scheme<d>& s : all) {
            const auto cell = [&](const char* arrangement, plot::Values Curves::*error) {
                const plot::Values& errors = named(arrangement, s.name).*error;
                return errors.empty() || (error == &Curves::value && !s.value)
                           ? std::string{}
                           : convergence_detail::with_order(n, errors);
            };
            story.row({s.label, cell("even", &Curves::value), cell("jittered", &Curves::value),
                       cell("even", &Curves::slope), cell("jittered", &Curves::slope)});
        }
        run.fill(name_, story.markdown());
        const auto near = [](double order, double expected) { return std::abs(order - expected) < 0.2; };
        run.claim("sph-saturates", [=] {
            return near(value("jittered", "sph"), 0) && slope("jittered", "sph") < -0.8 &&
                   near(slope("jittered", "differences"), 0);
        });
        run.claim("values-by-order",
                  [=] { return near(value("jittered", "cspm"), 1) && near(value("jittered", "fit"), 2); });
        run.claim("slopes-by-order", [=] {
            for (const char* scheme : {"cspm", "linear", "fit"}) {
                if (!near(slope("jittered", scheme), 1) || !near(slope("even", scheme), 2)) return false;
            }
            return true;
        });
    } else {
        run.claim("trap", [=] {
            return std::abs(slope("jittered", "by-axes")) < 0.2 && slope("jittered", "cspm") > 0.9;
        });
    }
}

}  // namespace sph::consistency
