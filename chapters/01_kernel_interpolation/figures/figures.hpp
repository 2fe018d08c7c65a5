#pragma once
#include <string>

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

/// `count` values from low to high, evenly or in equal ratios (low > 0). count >= 2.
plot::Values linear_space(double low, double high, std::size_t count);
plot::Values log_space(double low, double high, std::size_t count);

}  // namespace sph::interpolation
