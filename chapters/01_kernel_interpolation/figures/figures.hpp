#pragma once
#include <string>

#include "common/core/vec.hpp"
#include "common/plot/figure.hpp"
#include "common/report/chapter.hpp"

/// What several figures share.
namespace sph::interpolation {

/// Line style of a kernel, the same in every figure: `index` is its place in Kernels<d>.
plot::Style kernel_style(std::size_t index, const std::string& label, bool markers = false);
/// The same for the five kernels that the text speaks of; the others are thin and grey, with one entry in the
/// legend for all.
plot::Style told_style(std::size_t index, const std::string& label, bool markers = false);
/// Whether the text speaks of this kernel.
bool is_told(std::string_view name);
/// A kernel's name as a label: "cubic spline", "Wendland C2".
std::string kernel_label(std::string_view name);

/// A filled disc for a particle of a drawing, `size` [points].
plot::Style spot(plot::Colour colour, std::string label, double size);
/// Particles of the plane: one of them, the circle of radius `reach` around it, who lies inside, and the
/// others. `named`: with a legend entry each.
void draw_support(plot::Panel& panel, const Columns<2>& x, std::size_t centre, double reach, bool named);

/// `count` values from low to high, evenly or in equal ratios (low > 0). count >= 2.
plot::Values linear_space(double low, double high, std::size_t count);
plot::Values log_space(double low, double high, std::size_t count);

}  // namespace sph::interpolation
