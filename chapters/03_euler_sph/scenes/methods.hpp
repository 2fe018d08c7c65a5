#pragma once
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "chapters/03_euler_sph/gas.hpp"
#include "common/app/command_line.hpp"
#include "common/plot/figure.hpp"

/// The resolutions of this chapter by name, each with any kernel: compiled once for all kernels.
namespace sph::euler {

/// A way to run a gas: its resolution, its kernel, and h in spacings.
struct GasMethod {
    std::string resolution = "consistent-h";
    std::string kernel = "cubic";
    double h_over_dx = 1.2;
    std::string name{}, label{};  ///< for results.csv and figures
    plot::Style look{};
};

const std::vector<std::string>& resolution_names();
/// Those whose forces are functions of the positions, so that there is a star at rest.
const std::vector<std::string>& resolutions_at_rest();

/// The methods that are compared: one h, mean h, h without and with Omega, and the best of the chapter, the
/// super-Gaussian with its h in spacings.
std::vector<GasMethod> compared_methods(double best_h_over_dx = 1.35);

/// The options --resolution, --kernel and --h-over-dx of a scene.
struct MethodChoice {
    GasMethod method{};
    /// The method. Throws app::UsageError for an h at which particles have no neighbours.
    const GasMethod& chosen() const;
    void declare(app::CommandLine& line, const std::vector<std::string>& resolutions);
};

/// A gas on a line: visits the resolution that a method names; dx is the spacing that a fixed h counts in.
/// Throws std::invalid_argument for a name that is not known.
template <class Visit>
auto with_resolution_at_rest(const GasMethod& method, double dx, Visit&& visit) {
    using K = AnyKernel<1>;
    const K kernel{method.kernel};
    const HRule rule{method.h_over_dx};
    if (method.resolution == "fixed-h") return visit(FixedH<K>{method.h_over_dx * dx, kernel});
    if (method.resolution == "without-omega") return visit(WithoutOmega<K>{rule, 1e-12, kernel});
    if (method.resolution == "consistent-h") return visit(ConsistentH<K>{rule, 1e-12, kernel});
    throw std::invalid_argument{"no such resolution: " + method.resolution};
}
template <class Visit>
auto with_resolution(const GasMethod& method, double dx, Visit&& visit) {
    using K = AnyKernel<1>;
    const K kernel{method.kernel};
    if (method.resolution == "continuity")
        return visit(ContinuityH<K, PhiIsDensity>{method.h_over_dx * dx, kernel});
    if (method.resolution == "averaged-h") return visit(AveragedH<K>{HRule{method.h_over_dx}, kernel});
    return with_resolution_at_rest(method, dx, visit);
}

using LineGas = Integrated<1>;

/// A gas of some matter on a line.
template <class Matter, class Boundary, class Resolution, class... External>
std::unique_ptr<LineGas> line_gas(std::size_t n, Resolution resolution, Matter matter, Boundary boundary,
                                  int threads, External... external) {
    return std::make_unique<Gas<Resolution, Matter, Boundary, External...>>(
        n, std::move(resolution), std::move(matter), std::move(boundary), threads, external...);
}

}  // namespace sph::euler
