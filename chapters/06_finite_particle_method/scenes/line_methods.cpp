#include "chapters/06_finite_particle_method/scenes/line_methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "common/plot/looks.hpp"
#include "common/plot/method_looks.hpp"

namespace sph::fpm {
namespace {

LineMethod of_family(const std::string& name, const std::string& label, const std::string& estimate,
                     int order, Moving moving) {
    return {name, label, plot::look_of(name), estimate, order, moving};
}

/// The members of the family, all in one way of moving.
std::vector<LineMethod> family(Moving moving) {
    const auto member = [&](const std::string& name, const std::string& label) {
        return of_family(name, label, name, 2, moving);
    };
    return {member("sph", "SPH"),   member("brookshaw", "SPH, Brookshaw"),
            member("cspm", "CSPM"), member("fpm", "FPM"),
            member("sfpm", "SFPM"), member("taylor", "Taylor SPH"),
            member("mls", "MLS")};
}

}  // namespace

BurgersScene LineMethod::on(BurgersScene scene) const {
    scene.estimate = estimate, scene.order = order, scene.moving = moving;
    scene.kernel = kernel, scene.h_over_dx = h_over_dx;
    return scene;
}

plot::Style LineMethod::styled() const {
    plot::Style style = look;
    style.label = label;
    return style;
}

const report::Methods<LineMethod>& still_methods() {
    static const report::Methods<LineMethod> methods{
        "sfpm-4", [] {
            auto all = family(Moving::still);
            all.push_back(of_family("sfpm-4", "SFPM, order 4", "sfpm", 4, Moving::still));
            all.push_back({"fdm", "differences, order 2", plot::competitor(""), "fdm", 2});
            all.push_back(
                {"fdm-4", "differences, order 4", plot::competitor("", plot::Marker::plus), "fdm", 4});
            return all;
        }()};
    return methods;
}

const report::Methods<LineMethod>& moving_methods() {
    // [methods]
    static const report::Methods<LineMethod> methods{
        "frame-4", [] {
            auto all = family(Moving::with_u);
            all.push_back(of_family("xsph", "XSPH", "sfpm", 2, Moving::with_smoothed_u));
            all.push_back({"shifting", "shifting", plot::rest(""), "sfpm", 2, Moving::shifted});
            all.push_back({"repulsion", "repulsion", plot::rest(""), "sfpm", 2, Moving::repelled});
            all.push_back(of_family("remesh-fit", "remeshed by MLS", "sfpm", 2, Moving::remeshed_by_fit));
            all.push_back(of_family("remesh-m4", "remeshed by M4′", "sfpm", 2, Moving::remeshed_by_sharing));
            all.push_back(of_family("frame-2", "moving frame, order 2", "mls", 2, Moving::to_wanted_places));
            all.push_back(of_family("frame-4", "moving frame, order 4", "mls", 4, Moving::to_wanted_places));
            return all;
        }()};
    // [end]
    return methods;
}

std::string written(double viscosity) {
    return fmt::format("{:g}", viscosity);
}

const std::vector<std::string>& ends_names() {
    static const std::vector<std::string> names{"frozen", "free", "mirror", "none"};
    return names;
}

Ends ends_named(const std::string& name) {
    constexpr std::array all{Ends::frozen, Ends::free, Ends::mirror, Ends::none};
    const auto& names = ends_names();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) throw std::invalid_argument{"no such ends: " + name};
    return all[static_cast<std::size_t>(found - names.begin())];
}

}  // namespace sph::fpm
