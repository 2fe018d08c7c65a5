#pragma once
#include "chapters/06_finite_particle_method/scenes/burgers.hpp"
#include "common/report/method.hpp"

/// The ways to solve Burgers' equation by name, in the order in which the chapter tells of them.
namespace sph::fpm {

struct LineMethod {
    std::string name, label;
    plot::Style look;
    std::string estimate;  ///< a member of the family, or "fdm"
    int order = 2;
    Moving moving = Moving::still;
    std::string kernel = "quintic";
    double h_over_dx = 1;
    app::Parameters parameters{};

    /// The scene with this method; what else it says stays.
    BurgersScene on(BurgersScene scene) const;
    plot::Style styled() const;
};

/// Particles that stand still. Recommended: the fit of order 4.
const report::Methods<LineMethod>& still_methods();
/// Particles that move. Recommended: those that move to wanted places, with a fit of order 4.
const report::Methods<LineMethod>& moving_methods();

/// A viscosity as figures and results.csv write it: "0.005".
std::string written(double viscosity);

/// frozen, free, mirror, none
const std::vector<std::string>& ends_names();
/// Throws std::invalid_argument for a name that is none of them.
Ends ends_named(const std::string& name);

}  // namespace sph::fpm
