#include <algorithm>
#include <cmath>
#include <map>

#include "chapters/02_consistency/figures/figures.hpp"
#include "chapters/02_consistency/scenes/options.hpp"

namespace sph::consistency {
namespace {

constexpr std::size_t per_side = 64;

/// |error of the slope| at each particle over the largest slope.
plot::Values slope_errors(const Estimated<2>& e, const Scheme<2>& scheme) {
    double scale = 0;
    for (std::size_t i = 0; i < e.exact.size(); ++i)
        scale = std::max(scale, std::hypot(e.exact_slope[0][i], e.exact_slope[1][i]));
    plot::Values error;
    for (std::size_t i = 0; i < e.exact.size(); ++i) {
        error.push_back(std::hypot((e.*scheme.slope)[0][i] - e.exact_slope[0][i],
                                   (e.*scheme.slope)[1][i] - e.exact_slope[1][i]) /
                        scale);
    }
    return error;
}

void draw(plot::Panel& panel, int column, const Estimated<2>& e, const Scheme<2>& scheme,
          plot::Values error) {
    for (double& value : error) value = std::clamp(value, 1e-4, 1.0);
    plot::Discs discs{.name = scheme.name,
                      .x = e.x[0],
                      .y = e.x[1],
                      .value = error,
                      .data_diameter = 1.15 / static_cast<double>(per_side)};
    discs.bar = {
        .label = "error of ∇$A$ / largest ∇$A$", .map = plot::Map::viridis, .scale = plot::Scale::log};
    discs.bar.range = {1e-4, 1.0};
    discs.bar.shown = column == 2;
    panel.titled(scheme.label + " (" + scheme.slope_equation + ")").particles(discs);
    panel.labels("$x$", column == 0 ? "$y$" : "").x_range(0, 1).y_range(0, 1);
    panel.equal_aspect = true;
    panel.grid = false;
}

class MapsFigure {
  public:
    void declare(app::CommandLine& line) { options_.declare(line); }
    void run(report::Run& run) const {
        plot::Figure figure{"maps", 1, 3};
        figure.panel_width = 300;
        figure.panel_height = 300;
        const auto e = estimate<2>(options_.set(Arrangement::jittered, per_side, run), wave<2>());
        report::Table table{
            {"∇A on 64² jittered particles", "relative L2 error", "largest error / largest slope"}};
        int column = 0;
        std::map<std::string, double> l2_of;
        for (const auto& scheme : schemes<2>()) {
            const plot::Values error = slope_errors(e, scheme);
            const double worst = *std::max_element(error.begin(), error.end());
            const double l2 = slope_error(e, scheme, Where::everywhere);
            run.record(scheme.name, per_side * per_side, {{"l2_slope", l2}, {"linf_slope", worst}});
            table.row({scheme.label, report::number(l2, 2), report::number(worst, 2)});
            l2_of[scheme.name] = l2;
            if (scheme.name != "differences" && scheme.name != "by-axes" && scheme.name != "cspm") continue;
            draw(figure.at(0, column), column, e, scheme, error);
            ++column;
        }
        run.save(figure);
        run.fill("maps", table.markdown());
        run.claim(
            "axes-are-not-enough", [&] { return l2_of["by-axes"] > 1.7 * l2_of["cspm"]; },
            report::Needs::any_run);
    }

  private:
    ParticleSetOptions options_;
};

}  // namespace

report::Task maps() {
    return MapsFigure{};
}

}  // namespace sph::consistency
