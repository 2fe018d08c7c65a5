#pragma once
#include <string>
#include <vector>

#include "chapters/02_consistency/repair.hpp"
#include "chapters/02_consistency/scenes/functions.hpp"
#include "common/core/arrangement.hpp"

/// What every scheme makes of a function on a set of particles, and how wrong it is. Compiled once for all
/// kernels.
namespace sph::consistency {

/// How much space a particle stands for.
enum class Volumes {
    summed,  ///< m/rho with rho = sum m W, as in a simulation
    equal    ///< 1/N, the exact mean
};

/// One set of particles of the unit interval or square, which ends where its particles end. `kernel` is one
/// of any_kernel_names(); h_over_dx > 0; jitter in spacings, for jittered particles.
struct ParticleSet {
    std::string kernel = "quintic";
    Arrangement arrangement = Arrangement::even;
    std::size_t per_side = 100;
    double h_over_dx = 1.2;
    double jitter = 0.2;
    std::uint64_t seed = 1;
    Volumes volumes = Volumes::summed;
    int threads = 1;

    double h() const { return h_over_dx / static_cast<double>(per_side); }
    template <int d>
    Columns<d> points() const {
        return make_points<d>(arrangement, per_side, jitter, seed);
    }
};

/// Values and slopes at the particles: exact, and by each scheme.
template <int d>
struct Estimated {
    Columns<d> x;
    Column exact;
    Columns<d> exact_slope;
    Column sph, shepard, fit;  // (2.8), (92), line fit
    // (2.11), (2.14), (94) by axes, (94), linear, line fit
    Columns<d> plain, difference, axis, matrix, linear, slope;
    std::vector<bool> inside;  // neither their kernel nor their neighbours' reaches an end
    Repairs repairs;
};
/// d = 1, 2. Throws std::invalid_argument for an unknown kernel.
template <int d>
Estimated<d> estimate(const ParticleSet& set, const Function<d>& function);
extern template Estimated<1> estimate<1>(const ParticleSet&, const Function<1>&);
extern template Estimated<2> estimate<2>(const ParticleSet&, const Function<2>&);

/// CSPM's second derivative at the particles of a line, and their positions.
struct Curvature {
    Column x, value;
};
Curvature cspm_curvature(const ParticleSet& set, const Function<1>& function);

/// A way to interpolate: what figures and tables call it, and where Estimated holds its values and slopes
/// (either may be missing).
template <int d>
struct Scheme {
    std::string name, label, value_equation, slope_equation;
    Column Estimated<d>::*value = nullptr;
    Columns<d> Estimated<d>::*slope = nullptr;
};
template <int d>
std::vector<Scheme<d>> schemes();
extern template std::vector<Scheme<1>> schemes<1>();
extern template std::vector<Scheme<2>> schemes<2>();

/// Relative L2 errors, sqrt(sum |estimate - exact|^2 / sum |exact|^2), of values and slopes over all
/// particles or over those inside.
enum class Where { everywhere, inside };
template <int d>
double value_error(const Estimated<d>& e, const Scheme<d>& scheme, Where where);
template <int d>
double slope_error(const Estimated<d>& e, const Scheme<d>& scheme, Where where);

}  // namespace sph::consistency
