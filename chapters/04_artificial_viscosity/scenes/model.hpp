#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/core/boundary.hpp"
#include "common/core/counters.hpp"
#include "common/core/unstable.hpp"

/// A dissipative gas without its types: what scenes need of it, so that each scene is written once and each
/// method is compiled once. One virtual call a step, none a particle.
namespace sph {

/// A way to dissipate, by name.
struct Method {
    std::string name;        ///< for options and results.csv
    std::string label;       ///< for figures
    std::string kernel;      ///< of its own
    double h_over_dx = 1.2;  ///< h in spacings: sigma of (4.2)
};

template <int d>
class Model {
  public:
    virtual ~Model() = default;

    /// Particle i of n: position, velocity, mass, density to begin the search for h with, thermal energy.
    virtual void set(std::size_t i, const Vector<d>& x, const Vector<d>& v, double m, double rho,
                     double u) = 0;
    /// Particles from this one on keep their velocity: layers that stand for the gas beyond an end.
    virtual void fix_from(std::size_t first) = 0;
    /// Density, smoothing length and pressure at the present positions.
    virtual void resolve(double t) = 0;
    /// Moves on from t to `end` (DissipativeGas::advance); after_step(t) may throw to stop.
    virtual void advance(
        double& t, double end, double courant,
        const std::function<void(double)>& after_step = [](double) {}) = 0;

    virtual std::size_t size() const = 0;
    virtual std::size_t moving() const = 0;
    virtual const Columns<d>& x() const = 0;
    virtual const Columns<d>& v() const = 0;
    virtual const Column& m() const = 0;
    virtual const Column& rho() const = 0;
    virtual const Column& p() const = 0;
    virtual const Column& u() const = 0;
    virtual double energy() const = 0;
    virtual Vector<d> momentum() const = 0;
    virtual Counters& counters() = 0;
};

/// Ends a run that has done `most` steps and is not at its end: throws Unstable at time t.
template <int d>
void require_fewer_steps(Model<d>& gas, long most, double t) {
    if (gas.counters().steps >= most)
        throw Unstable{t, Unstable::no_particle, "the number of steps", static_cast<double>(most)};
}

/// The methods in one dimension, from the oldest to the best; the last is the recommended one.
const std::vector<Method>& tube_methods();
/// The viscosity of Monaghan & Gingold (1983) with the Gaussian and the super-Gaussian kernel.
const std::vector<Method>& kernel_methods();
/// The method of that name. Throws std::invalid_argument.
const Method& tube_method(const std::string& name);
const Method& best_tube_method();

/// `n` particles in the box. gamma > 1. Throws std::invalid_argument for an unknown method.
std::unique_ptr<Model<1>> make_model(const Method& method, std::size_t n, double gamma, const Box<1>& box,
                                     int threads);

}  // namespace sph
