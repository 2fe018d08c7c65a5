#include <map>

#include "chapters/06_finite_particle_method/scenes/interpolation.hpp"
#include "chapters/06_finite_particle_method/scenes/line_methods.hpp"
#include "common/report/norms.hpp"

/// Errors of value, slope and curvature against N, on jittered particles in one and two dimensions.
namespace sph::fpm {
namespace {

struct Entry {
    std::string name;  ///< of the look
    Choice choice;
};
using Orders = std::map<std::string, std::array<double, 3>>;

template <int d>
Orders draw(report::Run& run, plot::Figure& figure, int row, const std::vector<Entry>& entries,
            const std::vector<std::size_t>& sizes, double h_over_dx) {
    Orders orders;
    const char* const quantities[] = {"value", "slope", "curvature"};
    for (int degree = 0; degree <= 2; ++degree)
        figure.at(row, degree)
            .log_log()
            .titled(std::string{quantities[degree]} + ", " + std::to_string(d) + "D")
            .labels(d == 1 ? "particles $N$" : "particles along a side", "relative $L$_{2} error")
            .legend.shown = row == 0 && degree == 0;
    for (const Entry& entry : entries) {
        plot::Values n;
        std::array<plot::Values, 3> error;
        for (const std::size_t size : sizes) {
            constexpr std::size_t seeds = d == 1 ? 8 : 1;
            std::array<double, 3> mean{};
            for (std::size_t s = 0; s < seeds; ++s) {
                ParticleSet set;
                set.arrangement = Arrangement::jittered, set.per_side = size, set.h_over_dx = h_over_dx;
                set.jitter = 0.3, set.seed = run.seed() + s;
                const auto e = interpolate<d>(set, plane_wave<d>, entry.choice);
                for (int k = 0; k <= 2; ++k)
                    mean[static_cast<std::size_t>(k)] +=
                        e.error(k, consistency::Where::everywhere) / static_cast<double>(seeds);
            }
            n.push_back(static_cast<double>(size));
            for (std::size_t k = 0; k < 3; ++k) error[k].push_back(mean[k]);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            orders[entry.name][k] = report::fitted_order(n, error[k]);
            const std::string name = std::string{"rate_"} + quantities[k] + "_" + std::to_string(d) + "d";
            run.record(entry.name, sizes.back(), {{name, orders[entry.name][k]}});
            figure.at(row, static_cast<int>(k)).curve(n, error[k], still_methods()[entry.name].styled());
        }
    }
    return orders;
}

}  // namespace

void orders(report::Run& run) {
    plot::Figure figure{"orders", 2, 3};
    const std::vector<Entry> plane{{"cspm", {"cspm", 2}}, {"fpm", {"fpm", 2}}, {"sfpm", {"sfpm", 2}}};
    std::vector<Entry> line = plane;
    line.insert(line.begin(), {"sph", {"sph", 2}});
    line.push_back({"sfpm-4", {"sfpm", 4}});
    const Orders one =
        draw<1>(run, figure, 0, line, run.sizes({50, 100, 200}, {50, 100, 200, 400, 800}), 1.4);
    const Orders two = draw<2>(run, figure, 1, plane, run.sizes({16, 32}, {16, 32, 64, 128}), 1.6);
    report::Table table{{"member", "1D: value", "slope", "curvature", "2D: value", "slope", "curvature"}};
    for (const Entry& entry : line) {
        std::vector<std::string> row{still_methods()[entry.name].label};
        for (const double order : one.at(entry.name)) row.push_back(report::fixed(order, 1));
        for (std::size_t k = 0; k < 3; ++k)
            row.push_back(two.count(entry.name) > 0 ? report::fixed(two.at(entry.name)[k], 1) : "–");
        table.row(row);
    }
    run.fill("orders", table.markdown());
    run.claim("orders-of-family", [&] {
        const auto near = [](double order, double wanted) { return std::abs(order - wanted) < 0.2; };
        const auto right = [&](const char* name) {
            const auto& p = one.at(name);
            return near(p[0], 3) && near(p[1], 2) && p[2] > 1.2 && p[2] < 1.8 && near(two.at(name)[1], 2) &&
                   two.at(name)[0] > 2.8 && two.at(name)[2] > 1.2;
        };
        return right("fpm") && right("sfpm") && one.at("sph")[2] < 0 && one.at("sph")[1] < 0.2;
    });
    run.claim("cspm-stops", [&] { return one.at("cspm")[1] < 1.4 && one.at("cspm")[2] < 0.7; });
    run.save(figure);
}

}  // namespace sph::fpm
