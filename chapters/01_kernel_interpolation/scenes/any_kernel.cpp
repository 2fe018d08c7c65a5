#include "chapters/01_kernel_interpolation/any_kernel.hpp"

#include <array>
#include <stdexcept>
#include <tuple>

#include "chapters/01_kernel_interpolation/gaussians.hpp"

namespace sph {
namespace {

/// In the order of the numbers; the first three are those that AnyKernel compiles in.
template <int d>
using Choice = std::tuple<CubicSpline<d>, QuadraticSpline<d>, WendlandC4<d>, Gaussian<d>, SuperGaussian<d>,
                          QuarticSpline<d>, QuinticSpline<d>, Lucy<d>, WendlandC2<d>, WendlandC6<d>>;
constexpr int choices = static_cast<int>(std::tuple_size_v<Choice<1>>);

/// visit(kernel) of the kernel with that number.
template <int d, int n = 0, class Visit>
Tile visit_number(int number, Visit&& visit) {
    if constexpr (n + 1 < choices) {
        if (number != n) return visit_number<d, n + 1>(number, visit);
    }
    return visit(std::get<n>(Choice<d>{}));
}

}  // namespace

const std::vector<std::string>& any_kernel_names() {
    static const std::vector<std::string> names = std::apply(
        [](const auto&... kernel) { return std::vector<std::string>{std::string{kernel.name}...}; },
        Choice<1>{});
    return names;
}

double least_h_over_dx(std::string_view kernel_name) {
    return AnyKernel<1>{kernel_name}.W(Tile{0.0}, 1.0)[0];
}

template <int d>
AnyKernel<d>::AnyKernel(std::string_view kernel_name) : support{0}, number_{-1}, sigma_{0} {
    int number = 0;
    const auto take = [&](const auto& kernel) {
        if (kernel.name == kernel_name)
            name = kernel.name, support = kernel.support, number_ = number, sigma_ = kernel.sigma;
        ++number;
    };
    std::apply([&](const auto&... kernel) { (take(kernel), ...); }, Choice<d>{});
    if (number_ < 0) throw std::invalid_argument{"no such kernel: " + std::string{kernel_name}};
}

template <int d>
Tile AnyKernel<d>::called_w(int number, Tile q) {
    return visit_number<d>(number, [&](const auto& kernel) { return kernel.w(q); });
}
template <int d>
Tile AnyKernel<d>::called_f(int number, Tile q) {
    return visit_number<d>(number, [&](const auto& kernel) { return kernel.f(q); });
}
template <int d>
Tile AnyKernel<d>::called_d2w(int number, Tile q) {
    return visit_number<d>(number, [&](const auto& kernel) { return kernel.d2w(q); });
}

template class AnyKernel<1>;
template class AnyKernel<2>;
template class AnyKernel<3>;

}  // namespace sph
