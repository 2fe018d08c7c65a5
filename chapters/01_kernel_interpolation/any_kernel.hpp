#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "chapters/01_kernel_interpolation/splines.hpp"
#include "chapters/01_kernel_interpolation/wendland.hpp"
#include "common/core/tile.hpp"

/// A kernel as a value. With a kernel as a type each pass is compiled for each kernel; with this one it is
/// compiled once, and which formula a tile of eight pairs goes through is decided at the tile: a branch that
/// is predicted, since it is the same in all of a run.
namespace sph {

/// What AnyKernel can be: all of Kernels<d>, and the quadratic spline.
const std::vector<std::string>& any_kernel_names();

/// h over dx above which h = (h/dx) m/rho has a solution on a line: below it, with (h/dx) < h W(0), a
/// particle is its own density and h shrinks to nothing. Throws std::invalid_argument for a name that is none
/// of them.
double least_h_over_dx(std::string_view kernel_name);

/// The kernel of that name in d dimensions, for tiles. The three formulas that most runs use are compiled
/// into the pass, and cost what they cost as types (measured: 0 to 2 % more in 1D and 2D, 7 % in 3D); the
/// others are calls, one or two nanoseconds a pair.
template <int d>
class AnyKernel {
  public:
    static constexpr int dimension = d;
    std::string_view name;
    double support;

    /// Throws std::invalid_argument for a name that is none of any_kernel_names().
    explicit AnyKernel(std::string_view kernel_name);

    // As in Kernel: r is a tile of distances, h a number or a tile.
    template <class H>
    Tile W(const Tile& r, const H& h) const {
        return (sigma_ / to_dimension(d, h)) * w(r * (1.0 / h));
    }
    template <class H>
    Tile F(const Tile& r, const H& h) const {
        return (sigma_ / (to_dimension(d, h) * h * h)) * f(r * (1.0 / h));
    }
    template <class H>
    Tile d2W_dr2(const Tile& r, const H& h) const {
        return (sigma_ / (to_dimension(d, h) * h * h)) * called_d2w(number_, r * (1.0 / h));
    }

  private:
    // Places in any_kernel_names() of those that are compiled in.
    static constexpr int cubic = 0, quadratic = 1, wendland_c4 = 2;
    Tile w(const Tile& q) const {
        if (number_ == cubic) return CubicSpline<d>::w(q);
        if (number_ == quadratic) return QuadraticSpline<d>::w(q);
        if (number_ == wendland_c4) return WendlandC4<d>::w(q);
        return called_w(number_, q);
    }
    Tile f(const Tile& q) const {
        if (number_ == cubic) return CubicSpline<d>::f(q);
        if (number_ == quadratic) return QuadraticSpline<d>::f(q);
        if (number_ == wendland_c4) return WendlandC4<d>::f(q);
        return called_f(number_, q);
    }
    // Pure, so that a shape that no effect uses is not computed.
    [[gnu::const]] static Tile called_w(int number, Tile q);
    [[gnu::const]] static Tile called_f(int number, Tile q);
    [[gnu::const]] static Tile called_d2w(int number, Tile q);

    int number_;
    double sigma_;
};

extern template class AnyKernel<1>;
extern template class AnyKernel<2>;
extern template class AnyKernel<3>;

}  // namespace sph
