#include "chapters/01_kernel_interpolation/scenes/options.hpp"

#include "chapters/01_kernel_interpolation/kernels.hpp"

namespace sph::interpolation {

void SmoothingOptions::declare(app::CommandLine& line) {
    line.choice("kernel", kernel, kernel_names(), "smoothing kernel")
        .number("h-over-dx", h_over_dx, {0.5, 8}, "spacings", "smoothing length h")
        .number("jitter", jitter, {0, 1}, "spacings", "largest random shift of a particle along each axis");
}

void ParticleOptions::declare(app::CommandLine& line) {
    SmoothingOptions::declare(line);
    line.integer("particles", particles, 8, 1024, "particles along each side of the unit box");
}

}  // namespace sph::interpolation
