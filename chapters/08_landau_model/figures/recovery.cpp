#include <algorithm>
#include <cmath>
#include <functional>

#include "chapters/08_landau_model/fluids.hpp"
#include "chapters/08_landau_model/recovery.hpp"
#include "common/report/chapter.hpp"

/// How far each way to find the velocity from the momentum goes.
namespace sph::landau {
namespace {

constexpr double wrong = 1e-6;  ///< an error of lorentz beyond which a way has found nothing

/// What a way finds for four-velocities 1e-3..1e6 of radiation with s = 1.
struct Search {
    double largest = 0, last_found = 1, first_lost = 0;  ///< error and lorentz
    plot::Values at{}, evaluations{};                    ///< of w, until its first failure
};
Search search(int points, const std::function<Recovered(double q, double s_star)>& find) {
    const ConformalFluid radiation;
    Search all;
    for (int i = 0; i < points; ++i) {
        const double U = std::pow(10.0, -3 + 9.0 * i / (points - 1)), lorentz = std::sqrt(1 + U * U);
        const Recovered found = find(U * radiation.enthalpy(1), lorentz);
        const double error = std::abs(found.lorentz() / lorentz - 1);
        all.largest = std::max(all.largest, error <= 1 ? error : 1);
        if (!(error < wrong)) {
            if (all.first_lost == 0) all.first_lost = lorentz;
        } else if (all.first_lost == 0) {
            all.last_found = lorentz;
            all.at.push_back(U * U / (1 + lorentz));
            all.evaluations.push_back(found.evaluations);
        }
    }
    return all;
}

}  // namespace

void recovery(report::Run& run) {
    const ConformalFluid radiation;
    const int points = run.quick() ? 31 : 181;
    plot::Figure figure{"recovery"};
    figure.panel_width = 560;
    plot::Panel& axes = figure.panel().log_log().labels("γ – 1", "evaluations of $w$ until $U$ is found");
    report::Table table{{"way", "largest error of γ, up to 10⁶", "found up to γ", "first lost at γ"}};
    const auto add = [&](const std::string& name, const plot::Style& look, auto&& find) {
        const Search all = search(points, find);
        axes.curve(all.at, all.evaluations, look);
        run.record(name, static_cast<std::size_t>(points),
                   {{"linf_lorentz", all.largest}, {"fails_from_lorentz", all.first_lost}});
        table.row({look.label, report::number(all.largest, 1),
                   all.first_lost > 0 ? report::number(all.last_found, 3) : "10⁶",
                   all.first_lost > 0 ? report::number(all.first_lost, 3) : "–"});
        return all;
    };
    const Search bracketed =
        add("bracketed", {.label = "Newton in a bracket, in $U$", .colour = plot::cycle(0)},
            [&](double q, double s) { return recover(q, s, radiation); });
    const Search fixed = add("fixed-point", {.label = "fixed point, in $v$", .colour = plot::cycle(1)},
                             [&](double q, double s) { return recover_by_fixed_point(q, s, radiation); });
    const Search newton =
        add("newton", {.label = "Newton without a bracket, in $v$", .colour = plot::cycle(2)},
            [&](double q, double s) { return recover_by_newton(q, s, radiation); });
    run.save(figure);
    run.fill("recovery", table.markdown());
    run.claim("recovery-safe", [&] {
        return bracketed.first_lost == 0 && bracketed.largest < 1e-15 &&
               *std::max_element(bracketed.evaluations.begin(), bracketed.evaluations.end()) <= 7;
    });
    run.claim("recovery-unsafe", [&] {
        const double bound = std::sqrt(2.5);  // U^2 (1 - c_s^2) = 1
        return fixed.last_found <= bound && fixed.first_lost >= bound && newton.first_lost < 2 &&
               newton.first_lost > 1;
    });
}

}  // namespace sph::landau
