#include "chapters/02_consistency/figures/figures.hpp"
#include "common/report/norms.hpp"

namespace sph::consistency {
namespace {

struct Errors {
    double value = 0, slope = 0, value_everywhere = 0, slope_everywhere = 0;
};

/// Root mean square of the errors over a few sets of particles, for a smooth curve.
template <int d>
std::vector<Errors> mean_errors(ParticleSet set, int sets) {
    const auto all = schemes<d>();
    std::vector<Errors> mean(all.size());
    for (int s = 0; s < sets; ++s) {
        const auto e = estimate<d>(set, wave<d>());
        ++set.seed;
        for (std::size_t k = 0; k < all.size(); ++k) {
            if (all[k].value) {
                mean[k].value += square(value_error(e, all[k], Where::inside)) / sets;
                mean[k].value_everywhere += square(value_error(e, all[k], Where::everywhere)) / sets;
            }
            mean[k].slope += square(slope_error(e, all[k], Where::inside)) / sets;
            mean[k].slope_everywhere += square(slope_error(e, all[k], Where::everywhere)) / sets;
        }
    }
    for (Errors& e : mean) {
        for (double* error : {&e.value, &e.slope, &e.value_everywhere, &e.slope_everywhere})
            *error = std::sqrt(*error);
    }
    return mean;
}

std::string with_order(const plot::Values& n, const plot::Values& error) {
    const std::size_t last = n.size() - 1, middle = last / 2;
    return report::number(error[last], 2) + " (" +
           report::fixed(report::observed_order(n[middle], error[middle], n[last], error[last]), 1) + ")";
}

template <int d>
void converge(report::Run& run, const Options& options, plot::Figure& figure, const std::string& text) {
    figure.panel_width = 310;
    figure.panel_height = 260;
    const std::vector<std::size_t> sizes =
        d == 1 ? (run.quick() ? std::vector<std::size_t>{64, 128, 256, 512}
                              : std::vector<std::size_t>{64, 128, 256, 512, 1024, 2048, 4096})
               : (run.quick() ? std::vector<std::size_t>{24, 32, 48}
                              : std::vector<std::size_t>{24, 32, 48, 64, 96, 128, 192, 256});
    const auto all = schemes<d>();
    std::vector<std::vector<std::string>> rows(all.size());
    int column = 0;
    for (const auto& [arrangement, name] : {std::pair{Arrangement::even, std::string{"even"}},
                                            {Arrangement::jittered, "jittered"},
                                            {Arrangement::random, "random"}}) {
        ParticleSet set = options.set(run);
        set.arrangement = arrangement;
        std::vector<plot::Values> value(all.size()), slope(all.size()), everywhere(all.size());
        plot::Values count;
        for (const std::size_t n : sizes) {
            set.per_side = n;
            set.seed = run.seed();
            const int sets = arrangement == Arrangement::even ? 1 : d == 1 ? 8 : n < 128 ? 4 : 1;
            const auto errors = mean_errors<d>(set, sets);
            count.push_back(static_cast<double>(n));
            for (std::size_t k = 0; k < all.size(); ++k) {
                value[k].push_back(errors[k].value);
                slope[k].push_back(errors[k].slope);
                everywhere[k].push_back(errors[k].slope_everywhere);
                const std::string method = all[k].name + " " + std::to_string(d) + "D " + name;
                if (all[k].value) run.result(method, static_cast<long>(n), "l2_f", errors[k].value);
                run.result(method, static_cast<long>(n), "l2_slope", errors[k].slope);
                run.result(method, static_cast<long>(n), "l2_slope_with_ends", errors[k].slope_everywhere);
            }
        }
        const std::string axis = d == 1 ? "particles $N$" : "particles along a side";
        plot::Panel& top = figure.at(0, column).log_log().titled(name).labels(
            axis, column == 0 ? "rel. $L$_{2} error of $A$" : "");
        plot::Panel& bottom = figure.at(1, column).log_log().titled("").labels(
            axis, column == 0 ? "rel. $L$_{2} error of ∇$A$" : "");
        for (std::size_t k = 0; k < all.size(); ++k) {
            const auto last = static_cast<long>(sizes.back());
            const std::string method = all[k].name + " " + std::to_string(d) + "D " + name;
            if (rows[k].empty()) rows[k].push_back(all[k].label);
            if (all[k].value) {
                top.curve(count, value[k], scheme_style(all[k]));
                run.result(method, last, "rate_f", report::fitted_order(count, value[k]));
            }
            bottom.curve(count, slope[k], scheme_style(all[k]));
            run.result(method, last, "rate_slope", report::fitted_order(count, slope[k]));
            run.result(method, last, "rate_slope_with_ends", report::fitted_order(count, everywhere[k]));
            rows[k].push_back(all[k].value ? with_order(count, value[k]) : "");
            rows[k].push_back(with_order(count, slope[k]));
            if (arrangement == Arrangement::jittered) rows[k].push_back(with_order(count, everywhere[k]));
        }
        top.legend.shown = false;
        bottom.legend.shown = column == 2;
        bottom.legend.outside = true;
        ++column;
    }
    report::Table table{
        {std::to_string(d) + "D", "even: A", "∇A", "jittered: A", "∇A", "∇A, ends too", "random: A", "∇A"}};
    for (const auto& row : rows) table.row(row);
    run.save(figure);
    run.fill(text, table.markdown());
}

}  // namespace

void convergence(report::Run& run, const Options& options) {
    plot::Figure figure{"convergence", 2, 3};
    converge<1>(run, options, figure, "convergence");
}
void convergence_2d(report::Run& run, const Options& options) {
    plot::Figure figure{"convergence-2d", 2, 3};
    converge<2>(run, options, figure, "convergence-2d");
}

}  // namespace sph::consistency
