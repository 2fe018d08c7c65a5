#pragma once
#include <memory>
#include <optional>
#include <string>

#include "chapters/01_kernel_interpolation/smoothing.hpp"
#include "chapters/01_kernel_interpolation/splines.hpp"
#include "chapters/05_tensile_instability/elasticity.hpp"
#include "common/core/boundary.hpp"
#include "common/core/simulation.hpp"
#include "common/report/method.hpp"

/// Solids as simulations: what a scene places and marches, without knowing how stress is computed.
namespace sph::tensile {

using Solid = Simulation<2>;
using SolidKernel = CubicSpline<2>;

enum class Law {
    jaumann,            ///< (11.1)-(11.6) as printed, with viscosity
    artificial_stress,  ///< and artificial stress
    xsph,               ///< as printed, but particles move by XSPH with epsilon = 1
    corrected_rate,     ///< as printed, but with corrected velocity gradients
    total_lagrangian
};
/// A way to compute a solid. h in spacings: 1.5, as Gray, Monaghan & Swift; where sums stay on the places of
/// the beginning, few neighbours are enough.
struct SolidMethod {
    std::string name, label;
    Law law = Law::jaumann;
    double h_over_dx = 1.5;
};
/// All of them; the total Lagrangian one is recommended.
const report::Methods<SolidMethod>& solid_methods();

/// The same with another h, under a name and label that say so: what few or many neighbours do, alone.
SolidMethod with_h(const std::string& name, const std::string& suffix, double h_over_dx);

/// What a solid is made of, and how it is resolved.
struct SolidSetup {
    std::size_t n = 0;
    Elastic matter;
    double dx = 1;         ///< > 0, spacing of the particles
    double courant = 0.5;  ///< steps of courant dx/c_l
    double alpha = 0.1;    ///< artificial viscosity (8.4) of the Jaumann laws; >= 0
    double epsilon = 0.3;  ///< strength of the artificial stress; >= 0
    int threads = 1;
    std::optional<Box<2>> box{};  ///< periodic; without it, free space

    double time_step() const { return courant * dx / matter.longitudinal_speed(); }
};
ConstantH<SolidKernel> smoothing_of(const SolidSetup& setup, const SolidMethod& method);

/// n particles at rest in one place, for a scene to place, and to start(). Their spacing is setup.dx, their
/// density matter.rho0.
std::unique_ptr<Solid> make_solid(const SolidSetup& setup, const SolidMethod& method);
/// A total Lagrangian solid with friction nu >= 0 [1/time] and the column Load.
std::unique_ptr<Solid> make_loaded_solid(const SolidSetup& setup, double friction);

/// sum m (x v_y - y v_x), about the origin.
double angular_momentum(const Solid& solid);
/// In how many pieces a solid is, of particles that are within `link` of each other, and the particles of the
/// largest. Cost: n^2.
struct Pieces {
    std::size_t count = 0, largest = 0;
};
Pieces pieces_of(const Columns<2>& x, double link);

/// The matrix B of a particle on a square lattice that ends `rows` rows above it; h in spacings > 0.
Tensor<2> lattice_matrix(double h_over_dx, long rows);

}  // namespace sph::tensile
