#include "chapters/04_artificial_viscosity/scenes/tube.hpp"
#include "common/plot/looks.hpp"
#include "common/plot/method_looks.hpp"

/// What happens in Sod's tube: where its waves and some of its particles are, at every time.
namespace sph::shocks {
namespace {

/// Positions of every `stride`-th particle over time.
struct WorldLines {
    std::size_t stride;
    plot::Values t{};
    std::vector<plot::Values> x{};

    void look(double now, const Column& all) {
        t.push_back(now);
        x.resize((all.size() + stride - 1) / stride);
        for (std::size_t k = 0; k < x.size(); ++k) x[k].push_back(all[k * stride]);
    }
};

struct Name {
    std::string edge, text;
    double x, t;  ///< where it stands
};

void draw_waves(plot::Panel& panel, const ExactTube& exact, double time) {
    const std::vector<Name> names{{"left fan's head", "head of the fan", -0.42, 0.15},
                                  {"left fan's tail", "its tail", -0.13, 0.19},
                                  {"contact", "contact", 0.05, 0.185},
                                  {"right shock", "shock", 0.3, 0.15}};
    for (const Edge& edge : exact.edges) {
        panel.curve({0, edge.x}, {0, time}, {.colour = plot::black, .layer = 2}).style.dash =
            edge.name == "contact" ? plot::Dash::dashed : plot::Dash::solid;
        for (const Name& name : names) {
            if (name.edge == edge.name) panel.note(name.x, name.t, name.text);
        }
    }
}

}  // namespace

void x_t(report::Run& run) {
    TubeScene scene;
    scene.n = run.quick() ? 90 : 180;
    scene.threads = run.threads();
    WorldLines lines{run.quick() ? 3UL : 6UL};
    scene.watch = [&](double t, const Simulation<1>& gas) { lines.look(t, gas.get<Position>()[0]); };
    run_tube(scene, tube_methods().recommended());

    plot::Figure figure{"x-t"};
    figure.panel_width = 560;
    plot::Panel& panel = figure.panel().labels("$x$", "$t$").x_range(-0.5, 0.5).y_range(0, scene.time);
    std::string label = "every " + std::to_string(lines.stride) + "th particle";
    for (const plot::Values& x : lines.x) {
        panel.curve(x, lines.t, plot::rest(std::exchange(label, "")));
    }
    panel.curve({0, 0}, {0, 0}, {.label = "exact waves", .colour = plot::black});
    draw_waves(panel, gas_tube(scene).exact, scene.time);
    panel.legend.outside = true;
    run.save(figure);
}

}  // namespace sph::shocks
