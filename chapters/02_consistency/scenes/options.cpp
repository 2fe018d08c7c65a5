#include "chapters/02_consistency/scenes/options.hpp"

namespace sph::consistency {

void KernelOptions::declare(app::CommandLine& line) {
    line.choice("kernel", kernel, {"cubic", "quintic", "wendland-c4"}, "smoothing kernel")
        .number("h-over-dx", h_over_dx, {0.5, 8}, "spacings", "smoothing length h");
}

void ParticleSetOptions::declare(app::CommandLine& line) {
    KernelOptions::declare(line);
    line.number("jitter", jitter, {0, 0.5}, "spacings", "largest random shift of a particle along each axis")
        .choice("volumes", volumes, {"summed", "equal"},
                "of the particles: m/rho with summed densities, or 1/N");
}

}  // namespace sph::consistency
