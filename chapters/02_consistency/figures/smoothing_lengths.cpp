#include "chapters/02_consistency/scenes/graded_line.hpp"
#include "chapters/02_consistency/smoothing_lengths.hpp"
#include "chapters/02_consistency/figures/figures.hpp"
#include "common/report/norms.hpp"

namespace sph::consistency {
namespace {

using K = QuinticSpline<1>;
constexpr double eta = 1.2;

/// A force between pairs, m_i m_j (1/rho_i + 1/rho_j) grad_i W_ij: cancels in the sum if the kernel is
/// symmetric.
struct PairForce {
    using Reads = List<Density>;
    using ReadsJ = List<Mass>;
    using Adds = List<Acceleration>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.dv_dt -= (j.m * (1 / i.rho + 1 / j.rho) * pair.F) * pair.x_ij;
    }
};

using Line = Particles<1, Position, Mass, Density, Volume, Quantity, SmoothingLength, Value, Acceleration>;

struct Result {
    Column x, rho_error, h;
    double l2_rho = 0, l2_value = 0, net_force = 0, pairs = 0;
};

/// Density, then the interpolated wave and the forces, with one rule for h. `follow` sets h from the
/// densities.
template <class Smoothing, class Follow>
Result measure(std::size_t n, const Smoothing& smoothing, Support support, Follow&& follow) {
    Line line{n};
    line.x[0] = GradedLine::positions(n);
    line.m.assign(n, 1.0 / static_cast<double>(n));
    line.h.assign(n, eta / static_cast<double>(n));
    Neighbours<1> neighbours;
    const auto find = [&] {
        Column reach = line.h;
        for (double& r : reach) r *= K::support;
        neighbours.find(line.x, reach, support);
    };
    constexpr int rounds = 30;  // h and rho settle geometrically
    for (int round = 0; round < rounds; ++round) {
        find();
        sum_over_neighbours(line, neighbours, smoothing, Effects{SummedDensity{}});
        follow(line);
    }
    find();
    sum_over_neighbours(line, neighbours, smoothing, Effects{SummedDensity{}});
    for (std::size_t i = 0; i < n; ++i) {
        line.V[i] = line.m[i] / line.rho[i];
        line.A[i] = TestFunction<1>::value({line.x[0][i]});
    }
    sum_over_neighbours(line, neighbours, smoothing, Effects{Value{}, PairForce{}});
    Result result;
    plot::Values rho, exact_rho, value, exact_value;
    double net = 0, size = 0;
    for (std::size_t i = 0; i < n; ++i) {
        net += line.m[i] * line.dv_dt[0][i];
        size += std::abs(line.m[i] * line.dv_dt[0][i]);
        const double x = line.x[0][i];
        if (x < 0.2 || x > 0.8) continue;  // away from the ends, which are another matter
        result.x.push_back(x);
        result.h.push_back(line.h[i]);
        rho.push_back(line.rho[i]);
        exact_rho.push_back(GradedLine::density(x));
        result.rho_error.push_back(rho.back() / exact_rho.back() - 1);
        value.push_back(line.value[i]);
        exact_value.push_back(line.A[i]);
    }
    result.l2_rho = report::l2_error(rho, exact_rho);
    result.l2_value = report::l2_error(value, exact_value);
    result.net_force = std::abs(net) / size;
    result.pairs = static_cast<double>(neighbours.pairs()) / static_cast<double>(n);
    return result;
}

struct Rule {
    std::string name, label, equation;
    std::function<Result(std::size_t)> measure;
};

std::vector<Rule> rules() {
    const auto by_density = [](Line& line) {
        for (std::size_t i = 0; i < line.size(); ++i) line.h[i] = eta * line.m[i] / line.rho[i];
    };
    return {{"global", "one $h$, mean spacing", "",
             [](std::size_t n) { return measure(n, MeanH<K>{}, Support::symmetric, [](Line&) {}); }},
            {"mean-density", "one $h$ (59)", "59",
             [](std::size_t n) {
                 return measure(n, MeanH<K>{}, Support::symmetric, [](Line& line) {
                     line.h.assign(line.size(), mean_density_h(line.rho, line.m[0], eta, 1));
                 });
             }},
            {"own-h", "own $h_{i}$", "",
             [=](std::size_t n) { return measure(n, OwnH<K>{}, Support::gather, by_density); }},
            {"mean-h", "mean $h$ (60)", "60",
             [=](std::size_t n) { return measure(n, MeanH<K>{}, Support::symmetric, by_density); }},
            {"mean-kernel", "mean kernel (61)", "61",
             [=](std::size_t n) { return measure(n, MeanKernel<K>{}, Support::symmetric, by_density); }}};
}

}  // namespace

void smoothing_lengths(report::Run& run) {
    plot::Figure figure{"smoothing-lengths", 1, 3};
    figure.panel_width = 310;
    figure.panel_height = 260;
    plot::Panel& h = figure.at(0, 0).titled("$h$, 200 particles").log_y().labels("$x$", "$h$ / mean spacing");
    plot::Panel& error = figure.at(0, 1).titled("error of ρ, 200 particles").labels("$x$", "ρ / exact − 1");
    plot::Panel& order =
        figure.at(0, 2).titled("convergence").log_log().labels("particles $N$", "rel. $L$_{2} error of ρ");
    const std::vector<std::size_t> sizes = run.quick() ? std::vector<std::size_t>{100, 200, 400}
                                                       : std::vector<std::size_t>{100, 200, 400, 800, 1600};
    report::Table table{
        {"smoothing length", "ρ (order)", "A", "net force / sum of sizes", "neighbours a particle"}};
    std::size_t index = 0;
    for (const Rule& rule : rules()) {
        plot::Values n, rho;
        Result last;
        const plot::Style style{.label = rule.label,
                                .colour = plot::cycle(index),
                                .dash = index < 2 ? plot::Dash::dashed : plot::Dash::solid};
        for (const std::size_t size : sizes) {
            last = rule.measure(size);
            n.push_back(static_cast<double>(size));
            rho.push_back(last.l2_rho);
            run.result(rule.name, static_cast<long>(size), "l2_rho", last.l2_rho);
            run.result(rule.name, static_cast<long>(size), "l2_value", last.l2_value);
            run.result(rule.name, static_cast<long>(size), "net_force", last.net_force);
            run.result(rule.name, static_cast<long>(size), "neighbours", last.pairs);
            if (size != 200) continue;
            plot::Values scaled = last.h;
            for (double& value : scaled) value *= static_cast<double>(size);
            h.curve(last.x, scaled, style);
            error.curve(last.x, last.rho_error, style);
        }
        plot::Style marked = style;
        marked.marker = std::array{plot::Marker::square, plot::Marker::triangle_up, plot::Marker::plus,
                                   plot::Marker::circle, plot::Marker::diamond}
                            .at(index);
        order.curve(n, rho, marked);
        const double rate = report::observed_order(n[n.size() - 2], rho[n.size() - 2], n.back(), rho.back());
        run.result(rule.name, static_cast<long>(sizes.back()), "rate_l2_rho", rate);
        table.row({std::vector<std::string>{"one h, mean spacing", "one h, mean density (59)", "own h_i",
                                            "mean of both h (60)", "mean of both kernels (61)"}
                       .at(index),
                   report::number(rho.back(), 2) + " (" + report::fixed(rate, 1) + ")",
                   report::number(last.l2_value, 2),
                   last.net_force < 1e-12 ? "0" : report::number(last.net_force, 1),
                   report::fixed(last.pairs, 1)});
        ++index;
    }
    h.legend.shown = false;
    error.legend.shown = false;
    order.legend.outside = true;
    run.save(figure);
    run.fill("smoothing-lengths", table.markdown());
}

}  // namespace sph::consistency
