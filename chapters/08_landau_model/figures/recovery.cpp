#include <functional>

#include "chapters/08_landau_model/fluids.hpp"
#include "chapters/08_landau_model/recovery.hpp"
#include "common/report/chapter.hpp"

/// How far each way to find the velocity from the momentum goes.
namespace sph::landau {
namespace {

/// Relative error of the Lorentz factor that `find` gives for q of the four-velocity U; 1 where it gives
/// none.
template <class Fluid, class Find>
double recovery_error(const Fluid& fluid, double U, Find&& find) {
    const double lorentz = std::sqrt(1 + U * U), n_star = lorentz;
    const double q = U * fluid.enthalpy(n_star / lorentz);
    const double error = std::abs(find(q, n_star).lorentz() / lorentz - 1);
    return error <= 1 ? error : 1;
}

}  // namespace

void recovery(report::Run& run) {
    constexpr double floor = 1e-17;  // what a logarithmic axis shows of an error of 0
    const ConformalFluid radiation;
    const int points = run.quick() ? 13 : 61;
    plot::Figure figure{"recovery"};
    plot::Panel& axes = figure.panel().log_log().labels(
        "lorentz – 1", "relative error of lorentz (1: no answer; 10^{–17}: none)");
    report::Table table{{"way", "largest error, lorentz to 1e6", "fails from lorentz"}};
    const auto add = [&](const std::string& name, const std::string& label, std::size_t k, auto&& find) {
        plot::Values at, error;
        double largest = 0, fails = 0;
        for (int i = 0; i < points; ++i) {
            const double U = std::pow(10.0, -3 + 9.0 * i / (points - 1));
            const double e = recovery_error(radiation, U, find), lorentz = std::sqrt(1 + U * U);
            at.push_back(U * U / (1 + lorentz)), error.push_back(std::max(e, floor));
            largest = std::max(largest, e);
            if (e > 1e-6 && fails == 0) fails = lorentz;
        }
        axes.curve(at, error, {.label = label, .colour = plot::cycle(k), .marker = plot::Marker::circle});
        run.record(name, static_cast<std::size_t>(points),
                   {{"linf_lorentz", largest}, {"fails_from_lorentz", fails}});
        table.row({label, report::number(largest, 1), fails > 0 ? report::number(fails, 2) : "–"});
    };
    add("bracketed", "bracketed, in lorentz v", 0,
        [&](double q, double n) { return recover(q, n, radiation); });
    add("fixed-point", "fixed point, in v", 1,
        [&](double q, double n) { return recover_by_fixed_point(q, n, radiation); });
    add("newton", "Newton without a bracket, in v", 2,
        [&](double q, double n) { return recover_by_newton(q, n, radiation); });
    run.save(figure);
    run.fill("recovery", table.markdown());
}

}  // namespace sph::landau
