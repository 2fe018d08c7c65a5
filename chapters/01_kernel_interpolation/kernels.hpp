#pragma once
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "chapters/01_kernel_interpolation/gaussians.hpp"
#include "chapters/01_kernel_interpolation/splines.hpp"
#include "chapters/01_kernel_interpolation/wendland.hpp"

/// The kernels that this chapter compares, as one list, so that tests, figures and options run over every one
/// of them.
namespace sph {

template <int d>
using Kernels = std::tuple<Gaussian<d>, SuperGaussian<d>, CubicSpline<d>, QuarticSpline<d>, QuinticSpline<d>,
                           Lucy<d>, WendlandC2<d>, WendlandC4<d>, WendlandC6<d>>;

/// Calls visit(kernel) for every kernel in d dimensions, in the order of Kernels<d>.
template <int d, class Visit>
void for_each_kernel(Visit&& visit) {
    std::apply([&](const auto&... kernel) { (visit(kernel), ...); }, Kernels<d>{});
}

/// Calls visit(in_1d, in_2d, in_3d) for every kernel: the same kernel in all dimensions.
template <class Visit>
void for_each_kernel_in_all_dimensions(Visit&& visit) {
    [&]<std::size_t... n>(std::index_sequence<n...>) {
        (visit(std::tuple_element_t<n, Kernels<1>>{}, std::tuple_element_t<n, Kernels<2>>{},
               std::tuple_element_t<n, Kernels<3>>{}),
         ...);
    }
    (std::make_index_sequence<std::tuple_size_v<Kernels<1>>>{});
}

/// The names that options accept: gaussian, super-gaussian, cubic, ...
inline std::vector<std::string> kernel_names() {
    std::vector<std::string> names;
    for_each_kernel<1>([&](const auto& kernel) { names.emplace_back(kernel.name); });
    return names;
}

/// Calls visit(kernel) for the kernel of that name. Returns false if there is none.
template <int d, class Visit>
bool with_kernel(std::string_view name, Visit&& visit) {
    bool found = false;
    for_each_kernel<d>([&](const auto& kernel) {
        if (!found && kernel.name == name) {
            found = true;
            visit(kernel);
        }
    });
    return found;
}

}  // namespace sph
