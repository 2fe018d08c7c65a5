#include "chapters/03_euler_sph/scenes/methods.hpp"

#include "common/plot/method_looks.hpp"

namespace sph::euler {

const std::vector<std::string>& resolution_names() {
    static const std::vector<std::string> names{"fixed-h", "continuity", "averaged-h", "without-omega",
                                                "consistent-h"};
    return names;
}
const std::vector<std::string>& resolutions_at_rest() {
    static const std::vector<std::string> names{"fixed-h", "without-omega", "consistent-h"};
    return names;
}

std::vector<GasMethod> compared_methods(double best_h_over_dx) {
    std::vector<GasMethod> all{
        {"fixed-h", "cubic", 1.2, "fixed-h", "one $h$"},
        {"averaged-h", "cubic", 1.2, "averaged-h", "mean of both $h$"},
        {"without-omega", "cubic", 1.2, "without-omega", "own $h$, without $Ω_{h}$"},
        {"consistent-h", "cubic", 1.2, "consistent-h", "own $h$, with $Ω_{h}$"},
        {"consistent-h", "super-gaussian", best_h_over_dx, "super-gaussian", "with $Ω_{h}$, super-Gaussian"}};
    for (GasMethod& method : all) method.look = plot::look_of(method.name, method.label);
    return all;
}

void MethodChoice::declare(app::CommandLine& line, const std::vector<std::string>& resolutions) {
    line.choice("resolution", method.resolution, resolutions, "where density and h come from")
        .choice("kernel", method.kernel, any_kernel_names(), "smoothing kernel")
        .number("h-over-dx", method.h_over_dx, {0.5, 8}, "spacings",
                "smoothing length: of all, or h_over_dx of (3.21); above h W(0) of the kernel");
}

const GasMethod& MethodChoice::chosen() const {
    app::require_above("h-over-dx", method.h_over_dx, least_h_over_dx(method.kernel),
                       "with the kernel " + method.kernel);
    return method;
}

}  // namespace sph::euler
