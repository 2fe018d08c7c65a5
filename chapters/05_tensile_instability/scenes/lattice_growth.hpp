#pragma once
#include <functional>
#include <string>
#include <vector>

#include "chapters/05_tensile_instability/dispersion_matrix.hpp"
#include "common/report/chapter.hpp"

/// Which wave of a stressed lattice grows fastest.
namespace sph::tensile {

/// The kernel of that name on a lattice, h in dx. Throws std::invalid_argument for a name that
/// is none of kernel_names(), or an h whose support ends before the nearest neighbour.
template <int d>
LatticeKernel<d> named_lattice(const std::string& kernel, double h_over_dx,
                               const Tensor<d>& basis = square_lattice<d>());
extern template LatticeKernel<1> named_lattice(const std::string&, double, const Tensor<1>&);
extern template LatticeKernel<2> named_lattice(const std::string&, double, const Tensor<2>&);

/// A wave and its growth: 0 where no wave grows, and k is then 0, too.
template <int d>
struct GrowingWave {
    double rate = 0;  ///< [c/dx]
    Vector<d> k{};    ///< [1/dx]
};

/// The fastest growth over the whole Brillouin zone (square lattice: |k_x|, |k_y| <= pi): the best points of
/// a grid, `grid` intervals on pi, from each of which a search with shrinking steps goes on to the maximum.
/// Cost: d = 2: 2 grid^2 wave vectors; half of them for an isotropic pressure.
template <int d>
GrowingWave<d> fastest_wave(const LatticeKernel<d>& lattice, const Tensor<d>& pressure, int grid = 48);
extern template GrowingWave<1> fastest_wave(const LatticeKernel<1>&, const Tensor<1>&, int);
extern template GrowingWave<2> fastest_wave(const LatticeKernel<2>&, const Tensor<2>&, int);

/// The fastest growth on the points of that grid alone: some 1e-3 below the maximum   [c/dx].
template <int d>
double growth_on_grid(const LatticeKernel<d>& lattice, const Tensor<d>& pressure, int grid);
extern template double growth_on_grid(const LatticeKernel<1>&, const Tensor<1>&, int);
extern template double growth_on_grid(const LatticeKernel<2>&, const Tensor<2>&, int);

/// The speed of a long wave along x: omega/k of the pressure wave with `length` spacings   [c].
double long_wave_speed(const LatticeKernel<2>& lattice, double P, double length = 20);

/// The scene `lattice-growth` of the reader's own: CSV on standard output.
class LatticeGrowthCommand {
  public:
    void declare(app::CommandLine& line);
    void run(report::Run& run) const;

  private:
    std::string kernel_ = "cubic";
    double h_over_dx_ = 1.2, tension_x_ = 0;
    std::vector<double> pressure_{-0.5, -0.2, -0.1, 0.1, 0.2, 0.5};
};

}  // namespace sph::tensile
