#include <map>

#include "chapters/06_finite_particle_method/scenes/line_methods.hpp"
#include "chapters/06_finite_particle_method/scenes/turns.hpp"
#include "common/report/norms.hpp"

/// Still particles at gamma = 1: the protocol of (Ye et al. 2019, section 3), with two kinds of ends.
namespace sph::fpm {
namespace {

struct Series {
    std::vector<double> n, relative, seconds;
    double order() const { return report::fitted_order(n, relative); }
};
using All = std::map<std::string, Series>;

/// P at each N, by all methods, with the paper's steps of h/500.
All measure(report::Run& run, const std::string& ends, const std::vector<std::string>& names,
            const std::vector<std::size_t>& sizes) {
    All all;
    for (const std::string& name : names) {
        for (const std::size_t n : sizes) {
            BurgersScene scene = still_methods()[name].on({});
            scene.n = n, scene.viscosity = 1, scene.ends = ends_named(ends);
            scene.steps = 500 * static_cast<long>(n - 1);
            const BurgersRun line = run_burgers(scene);
            const double relative = line.relative;
            all[name].seconds.push_back(line.seconds);
            all[name].n.push_back(static_cast<double>(n - 1)), all[name].relative.push_back(relative);
            run.record(name + " " + ends, n, {{"relative_u", relative}});
        }
        run.record(name + " " + ends, sizes.back(), {{"rate_relative_u", all[name].order()}});
    }
    return all;
}

void draw(plot::Panel& panel, const All& all, const std::vector<std::string>& names) {
    panel.log_log().labels("intervals $N$ − 1", "relative error $P$ at $t$ = 1");
    for (const std::string& name : names)
        panel.curve(all.at(name).n, all.at(name).relative, still_methods()[name].styled());
}

void table_of_ends(report::Run& run, const All& frozen, const All& mirror,
                   const std::vector<std::string>& names) {
    report::Table table{{"method", "P frozen, N = 21", "41", "81", "161", "order", "P mirror, 81", "order"}};
    for (const std::string& name : names) {
        std::vector<std::string> row{still_methods()[name].label};
        for (std::size_t k = 0; k < 4; ++k) {
            const Series& one = frozen.at(name);
            row.push_back(k < one.n.size() ? report::number(one.relative[k], 2) : "");
        }
        row.push_back(report::fixed(frozen.at(name).order(), 2));
        row.push_back(report::number(mirror.at(name).relative.back(), 2));
        row.push_back(report::fixed(mirror.at(name).order(), 2));
        table.row(row);
    }
    run.fill("still", table.markdown());
}

/// E = P t/t_SPH (Ye et al. 2019, 24) at each N, t the time to find the rows and to apply them once.
void efficiency(report::Run& run, const All& frozen, const std::vector<std::string>& names) {
    report::Table table{{"method", "t over that of SPH, N = 161", "E, N = 21", "41", "81", "161"}};
    std::map<std::string, std::vector<double>> E, ratio;
    const std::vector<double>& n = frozen.at("sph").n;
    for (std::size_t k = 0; k < n.size(); ++k) {
        std::vector<std::function<void()>> works;
        for (const std::string& name : names) {
            BurgersScene scene = still_methods()[name].on({});
            scene.n = static_cast<std::size_t>(n[k]) + 1;
            works.push_back(rates_of(scene));
        }
        const std::vector<double> seconds = timed_in_turns(run, works);
        for (std::size_t m = 0; m < names.size(); ++m) {
            ratio[names[m]].push_back(seconds[m] / seconds[0]);
            E[names[m]].push_back(ratio[names[m]].back() * frozen.at(names[m]).relative[k]);
        }
    }
    for (const std::string& name : names) {
        std::vector<std::string> row{still_methods()[name].label, report::timing(ratio.at(name).back())};
        for (const double e : E.at(name)) row.push_back(report::timing(e));
        row.resize(6);
        table.row(row);
    }
    run.fill("still-efficiency", table.markdown());
    run.claim("efficiency", [&] {
        bool steady = true;  // each E is less than a third of the one before, the last as the first
        for (const char* name : {"cspm", "fpm", "sfpm"}) {
            for (std::size_t k = 1; k < E.at(name).size(); ++k)
                steady = steady && E.at(name)[k] < E.at(name)[k - 1] / 3;
            steady = steady && E.at(name).back() < E.at("sph").back() / 100;
        }
        return run.checking() || steady;
    });
    run.claim("work-eats-gain", [&] {
        const Series& one = frozen.at("sfpm");
        const double product = one.relative.back() * one.seconds.back() / (one.relative[0] * one.seconds[0]);
        return run.checking() || (product > 0.4 && product < 2.5);
    });
}

void assert_text(report::Run& run, const All& frozen, const All& mirror) {
    const auto second = [](const Series& one) { return std::abs(one.order() - 2) < 0.05; };
    run.claim("still-orders", [&] {
        return second(frozen.at("cspm")) && second(frozen.at("fpm")) && second(frozen.at("sfpm")) &&
               second(frozen.at("fdm")) && frozen.at("sfpm").relative.back() <= 8.1e-4 &&
               frozen.at("fpm").relative.back() <= 9.5e-4 &&
               frozen.at("sph").relative.back() > 900 * frozen.at("cspm").relative.back();
    });
    run.claim("still-monotonic", [&] {
        bool falls = true;
        for (const auto& [name, one] : frozen)
            falls = falls && std::is_sorted(one.relative.rbegin(), one.relative.rend());
        return falls;
    });
    run.claim("ends-decide", [&] {
        return mirror.at("sph").relative[2] < 0.01 * frozen.at("sph").relative[2] &&
               mirror.at("brookshaw").relative.back() < mirror.at("sfpm").relative.back() &&
               second(mirror.at("sph")) &&
               mirror.at("sph").relative.back() > mirror.at("sfpm").relative.back();
    });
    run.claim("steps-do-not-matter", [&] {
        double most = 0;
        for (const auto& [name, one] : frozen) {
            BurgersScene scene = still_methods()[name].on({});
            scene.n = 41, scene.viscosity = 1, scene.ends = Ends::frozen, scene.steps = 2 * 500 * 40;
            most = std::max(most, std::abs(run_burgers(scene).relative / one.relative[1] - 1));
        }
        return most < 1e-4;
    });
    run.claim("answer-still", [&] {
        const auto p = [](const All& all, const char* name) { return all.at(name).relative[2]; };
        return p(mirror, "brookshaw") < p(frozen, "sfpm") && p(mirror, "sfpm-4") < 1e-3 * p(frozen, "sfpm") &&
               p(frozen, "sfpm") < 0.1 * p(frozen, "brookshaw");
    });
    run.claim("fourth-is-difference", [&] {
        const Series &fit = mirror.at("sfpm-4"), &grid = mirror.at("fdm-4");
        bool same = std::abs(fit.order() - 4) < 0.1;
        for (std::size_t k = 0; k < fit.n.size(); ++k)
            same = same && std::abs(fit.relative[k] / grid.relative[k] - 1) < 1e-3;
        return same;
    });
}

}  // namespace

void still(report::Run& run) {
    const std::vector<std::string> names{"sph", "brookshaw", "cspm", "fpm", "sfpm", "taylor", "fdm"};
    std::vector<std::string> with_four = names;
    with_four.insert(with_four.end(), {"sfpm-4", "fdm-4"});
    const All frozen = measure(run, "frozen", names, run.sizes({21, 41}, {21, 41, 81, 161}));
    const All mirror = measure(run, "mirror", with_four, run.sizes({21, 41}, {21, 41, 81}));
    plot::Figure figure{"still", 1, 2};
    draw(figure.at(0, 0).titled("frozen ends"), frozen, {"sph", "brookshaw", "cspm", "sfpm", "fdm"});
    draw(figure.at(0, 1).titled("mirror images"), mirror, {"sph", "brookshaw", "sfpm", "sfpm-4", "fdm-4"});
    figure.at(0, 0).slope(-2, 40, 160, 0.02, "order 2");
    figure.at(0, 1).slope(-4, 20, 80, 3e-4, "order 4");
    figure.at(0, 0).y_range(3e-5, 20);
    table_of_ends(run, frozen, mirror, names);
    efficiency(run, frozen, {names.begin(), names.end() - 1});
    run.fill("still-fourth", report::number(mirror.at("sfpm-4").relative.back(), 2));
    assert_text(run, frozen, mirror);
    run.save(figure);
}

}  // namespace sph::fpm
