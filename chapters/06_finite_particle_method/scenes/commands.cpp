#include "chapters/06_finite_particle_method/scenes/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "chapters/06_finite_particle_method/scenes/estimators.hpp"
#include "chapters/06_finite_particle_method/scenes/line_methods.hpp"
#include "common/app/error.hpp"
#include "common/app/option_text.hpp"
#include "common/exact/burgers.hpp"
#include "common/plot/looks.hpp"

namespace sph::fpm {
namespace {

/// The method of that name, or the recommended one.
LineMethod chosen(const report::Methods<LineMethod>& methods, const std::string& name,
                  const std::string& motion) {
    if (name.empty()) return methods.recommended();
    const auto names = methods.names();
    if (std::find(names.begin(), names.end(), name) == names.end())
        throw app::UsageError{"--method: " + name + " is not allowed with --motion " + motion +
                              "; allowed: list, " + app::option_text::joined(names)};
    return methods[name];
}

/// The largest order that a member has in so many dimensions.
int largest_order(const std::string& member, long dimension) {
    if (member == "sph") return 2;
    const bool moments = member == "sfpm" || member == "taylor" || member == "mls";
    return moments && dimension == 1 ? 4 : 2;
}

std::string name_of_term(std::size_t k, const std::vector<std::size_t>& axes) {
    if (k == 0) return "f";
    std::string name = "f_";
    for (const std::size_t a : axes) name += "xyz"[a];
    return name;
}

}  // namespace

void BurgersCommand::declare(app::CommandLine& line) {
    line.choice("motion", motion_, {"still", "moving"}, "whether particles stand still or move")
        .text("method", method_, "NAME", "'list' names those of the motion; default: the recommended one")
        .choice("boundary", boundary_, ends_names(), "how u = 0 is told to the particles at the ends")
        .number("viscosity", viscosity_, {exact::Burgers::least_viscosity, exact::Burgers::largest_viscosity},
                "length^2/time", "gamma in u_t + u u_x = gamma u_xx")
        .integer("particles", particles_, 8, 2000, "between the ends")
        .number("time", time_, {0, exact::Burgers::largest_time, true}, "time", "how long the scene runs")
        .choice("kernel", kernel_, any_kernel_names(), "smoothing kernel; default: the method's")
        .number("h-over-dx", h_over_dx_, {0.5, 20}, "spacings", "smoothing length h; default: the method's");
}

void BurgersCommand::run(report::Run& run) const {
    const auto& methods = motion_ == "still" ? still_methods() : moving_methods();
    if (method_ == "list") return run.print(methods.text());
    LineMethod method = chosen(methods, method_, motion_);
    if (!kernel_.empty()) method.kernel = kernel_;
    if (!std::isnan(h_over_dx_)) method.h_over_dx = h_over_dx_;
    report::tell(run, method);
    BurgersScene scene;
    scene.n = static_cast<std::size_t>(particles_);
    scene.viscosity = viscosity_, scene.time = time_, scene.ends = ends_named(boundary_);
    scene.progress = run.progress();
    const BurgersRun line = [&] {
        try {
            return run_burgers(method.on(scene));
        } catch (const std::invalid_argument& error) {
            throw app::UsageError{"--boundary: " + boundary_ + " is not allowed with the method " +
                                  method.name + "; allowed: mirror"};
        }
    }();
    if (line.first_crossing >= 0)
        run.warn(fmt::format("particles have crossed, first at t = {:.3g}; at the end {} are out of order",
                             line.first_crossing, line.crossed));
    if (line.enlarged.flagged > 0)
        run.warn(fmt::format("{} neighbourhoods did not determine the fit: their support was enlarged",
                             line.enlarged.flagged));
    run.record(method.name, scene.n, line.measured());
    run.write("profile.csv", report::csv({{"x", line.x}, {"u", line.u}, {"exact_u", line.exact}}));
    plot::Figure figure{"burgers"};
    plot::Panel& panel = figure.panel().labels("$x$", "$u$");
    const exact::Burgers exact{viscosity_};
    plot::draw_exact(panel, 0, 1, [&](double x) { return exact.velocity(x, time_); });
    panel.points(line.x, line.u, plot::dots(method.styled()));
    run.save(figure);
}

void EstimateCommand::declare(app::CommandLine& line) {
    std::vector<std::string> names;
    for (const Member& member : members()) names.push_back(member.name);
    line.choice("member", member_, names, "of the family")
        .integer("order", order_, 1, 4, "of Taylor's series: 1, 2; in 1D also 4 for sfpm, taylor, mls")
        .choice("function", function_, {"two-gaussians", "wave", "parabola"}, "that is interpolated")
        .integer("dimension", dimension_, 1, 3, "of the box")
        .integer("particles", particles_, 8, 4096, "along each side of the box")
        .choice("arrangement", arrangement_, arrangement_names(), "of the particles")
        .number("jitter", jitter_, {0, 0.5}, "spacings", "largest random shift of a jittered particle")
        .choice("kernel", kernel_, any_kernel_names(), "smoothing kernel")
        .number("h-over-dx", h_over_dx_, {0.5, 20}, "spacings", "smoothing length h");
}

template <int d>
void EstimateCommand::run_in(report::Run& run) const {
    ParticleSet set;
    set.kernel = kernel_, set.arrangement = arrangement_named(arrangement_);
    set.per_side = static_cast<std::size_t>(particles_), set.h_over_dx = h_over_dx_;
    set.jitter = jitter_, set.seed = run.seed();
    const Choice choice{member_, static_cast<int>(order_)};
    const Interpolated<d> e = interpolate<d>(set, function_of_name<d>(function_), choice);
    const std::size_t n = e.inside.size();
    const bool has_inside = std::find(e.inside.begin(), e.inside.end(), true) != e.inside.end();
    for (int degree = 0; degree <= 2; ++degree) {
        const std::string name = degree == 0 ? "l2_f" : degree == 1 ? "l2_slope" : "l2_curvature";
        run.record(member_, n, {{name, e.error(degree, consistency::Where::everywhere)}});
        if (has_inside)
            run.record(member_, n, {{name + "_inside", e.error(degree, consistency::Where::inside)}});
    }
    run.record(member_, n,
               {{"enlarged", static_cast<double>(e.enlarged.flagged)},
                {"left", static_cast<double>(e.enlarged.left)}});
    std::vector<std::pair<std::string, std::span<const double>>> columns;
    for (std::size_t a = 0; a < d; ++a) columns.emplace_back(std::string{"xyz"[a]}, e.x[a]);
    for (std::size_t k = 0; k < derivatives<d>; ++k) {
        const std::string name = name_of_term(k, axes_of_term<d>(k));
        columns.emplace_back(name, e.estimated[k]);
        columns.emplace_back("exact_" + name, e.exact[k]);
    }
    run.write("profile.csv", report::csv(columns));
    plot::Figure figure{"estimate", 1, 3};
    const char* const titles[] = {"value", "slope along $x$", "curvature along $x$"};
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}, std::size_t{1 + d}}) {
        const int panel = k == 0 ? 0 : k == 1 ? 1 : 2;
        plot::Panel& axes = figure.at(0, panel).titled(titles[panel]).labels("exact", "estimated");
        const auto [low, high] = std::minmax_element(e.exact[k].begin(), e.exact[k].end());
        axes.curve({*low, *high}, {*low, *high}, plot::exact());
        axes.points(e.exact[k], e.estimated[k],
                    {.label = member_, .marker = plot::Marker::circle, .marker_size = 3});
    }
    run.save(figure);
}

void EstimateCommand::run(report::Run& run) const {
    const int most = largest_order(member_, dimension_);
    const bool plain = member_ == "sph" || member_ == "brookshaw";
    if (order_ > most || order_ == 3)
        throw app::UsageError{fmt::format("--order: {} is not allowed with {} in {} dimensions; allowed: {}",
                                          order_, member_, dimension_, most == 2 ? "1, 2" : "1, 2, 4")};
    if (plain && dimension_ > 1)
        throw app::UsageError{"--member: " + member_ + " is not allowed in more than 1 dimension; allowed: " +
                              "cspm, fpm, sfpm, taylor, mls"};
    const long largest = dimension_ == 1 ? 4096 : dimension_ == 2 ? 512 : 48;
    if (particles_ > largest)
        throw app::UsageError{fmt::format("--particles: {} is not allowed in {} dimensions; allowed: 8..{}",
                                          particles_, dimension_, largest)};
    if (dimension_ == 1) return run_in<1>(run);
    dimension_ == 2 ? run_in<2>(run) : run_in<3>(run);
}

}  // namespace sph::fpm
