#include <algorithm>
#include <cmath>

#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/01_kernel_interpolation/scenes/options.hpp"
#include "chapters/01_kernel_interpolation/scenes/test_function.hpp"
#include "common/plot/looks.hpp"
#include "common/report/norms.hpp"

namespace sph::interpolation {
namespace {

/// The interpolant and the exact value on a grid of pixels.
struct Pixels {
    plot::Values side, value, exact;
    Columns<2> particles;

    Pixels(const Setting& setting, std::size_t per_side) : side{linear_space(0, 1, per_side)} {
        Columns<2> positions;
        for (const double y : side) {
            for (const double x : side) {
                positions[0].push_back(x);
                positions[1].push_back(y);
                exact.push_back(TestFunction<2>::value({x, y}));
            }
        }
        Map map = interpolate_at(setting, positions);
        value = std::move(map.value);
        particles = std::move(map.particles);
    }
    plot::Field field(std::string name, plot::Values values) const {
        return {.name = std::move(name), .x = side, .y = side, .value = std::move(values)};
    }
};

void draw(plot::Figure& figure, const Pixels& pixels) {
    plot::Field value = pixels.field("interpolant", pixels.value);
    value.bar.label = "$A$";
    value.contours = linear_space(-2.5, 2.5, 11);
    plot::Values difference = pixels.value;
    double largest = 0;
    for (std::size_t k = 0; k < difference.size(); ++k) {
        difference[k] -= pixels.exact[k];
        largest = std::max(largest, std::abs(difference[k]));
    }
    plot::Field error = pixels.field("error", difference);
    error.bar = {.label = "interpolant − exact", .map = plot::Map::blue_red};
    error.bar.range = {-largest, largest};
    figure.at(0, 0).field(value);
    figure.at(0, 1).titled("its error, and the particles").field(error);
    figure.at(0, 1).points(pixels.particles[0], pixels.particles[1],
                           {.colour = plot::black, .marker = plot::Marker::circle, .marker_size = 1.2});
    for (const int column : {0, 1}) {
        figure.at(0, column).labels("$x$", column == 0 ? "$y$" : "").x_range(0, 1).y_range(0, 1);
        figure.at(0, column).equal_aspect = true;
        figure.at(0, column).grid = false;
    }
}

class MapFigure {
  public:
    void declare(app::CommandLine& line) { options_.declare(line); }
    void run(report::Run& run) const {
        const Pixels pixels{options_.setting(Arrangement::jittered, run),
                            run.quick() ? std::size_t{61} : std::size_t{101}};
        plot::Figure figure{"map", 1, 2};
        figure.panel_width = 330;
        figure.panel_height = 330;
        figure.at(0, 0).titled("interpolant, " + kernel_label(options_.kernel));
        draw(figure, pixels);
        run.save(figure);
        const double l2 = report::l2_error(pixels.value, pixels.exact);
        run.result(options_.kernel, options_.particles * options_.particles, "l2_value_map", l2);
        run.fill("map-error", report::percent(l2));
    }

  private:
    ParticleOptions options_;
};

}  // namespace

report::Task map() {
    return MapFigure{};
}

}  // namespace sph::interpolation
