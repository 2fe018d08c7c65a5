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

/// In space: the error of SFPM's slope of a wave on so many particles a side; of all particles, and of those
/// farther from the faces than the support of 16 a side.
struct InSpace {
    double all = 0, central = 0;
};
InSpace in_space(std::size_t size, double waves, unsigned long seed) {
    ParticleSet set;
    set.arrangement = Arrangement::jittered, set.per_side = size, set.h_over_dx = 1.4;
    set.jitter = 0.3, set.seed = seed;
    const auto e = interpolate<3>(set, wave_of<3>(waves), {"sfpm", 2});
    return {e.error(1, consistency::Where::everywhere), e.error_within(0.27)};
}

/// Its order between 8, 16 and 32 particles a side.
void measure_in_space(report::Run& run) {
    const std::size_t finest = run.quick() ? 20 : 32;
    const InSpace coarse = in_space(8, 1, run.seed()), middle = in_space(16, 1, run.seed()),
                  fine = in_space(finest, 1, run.seed()), long_middle = in_space(16, 0.5, run.seed()),
                  long_fine = in_space(finest, 0.5, run.seed());
    const auto order = [&](double before, double after) {
        return std::log(before / after) / std::log(static_cast<double>(finest) / 16);
    };
    const double first = std::log2(coarse.all / middle.all), second = order(middle.all, fine.all),
                 central = order(middle.central, fine.central),
                 long_central = order(long_middle.central, long_fine.central);
    run.record("sfpm", 16, {{"rate_slope_3d", first}});
    run.record("sfpm", finest,
               {{"rate_slope_3d", second},
                {"rate_slope_3d_central", central},
                {"rate_slope_3d_central_long", long_central}});
    run.fill("order-3d-coarse", report::fixed(first, 1));
    run.fill("order-3d-fine", report::fixed(second, 1));
    run.fill("order-3d-central", report::fixed(central, 2));
    run.fill("order-3d-long", report::fixed(long_central, 2));
    run.claim("order-in-space", [&] {
        return first < second - 0.1 && second < central - 0.03 && central < long_central - 0.02 &&
               std::abs(long_central - 2) < 0.05 && fine.all < fine.central;
    });
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
    figure.at(0, 0).slope(-3, 100, 800, 2e-4, "order 3");
    figure.at(0, 1).slope(-2, 100, 800, 4e-4, "order 2");
    figure.at(0, 2).slope(-1.5, 100, 800, 3e-3, "order 1.5");
    figure.at(1, 0).slope(-3, 20, 100, 8e-4, "order 3");
    figure.at(1, 1).slope(-2, 20, 100, 0.03, "order 2");
    figure.at(1, 2).slope(-1.5, 20, 100, 0.06, "order 1.5");
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
    measure_in_space(run);
    run.claim("cspm-stops", [&] { return one.at("cspm")[1] < 1.4 && one.at("cspm")[2] < 0.7; });
    run.save(figure);
}

}  // namespace sph::fpm
