#pragma once
#include "chapters/01_kernel_interpolation/scenes/measured.hpp"
#include "common/report/chapter.hpp"

/// What a reader chooses for the figures and scenes that interpolate the test function.
namespace sph::interpolation {

/// The kernel, and how disordered jittered particles are.
struct SmoothingOptions {
    std::string kernel = "cubic";
    double h_over_dx = 1.2;
    double jitter = 0.2;  // [spacings]

    void declare(app::CommandLine& line);
    Setting setting(Arrangement arrangement, std::size_t per_side, const report::Run& run) const {
        return {kernel, arrangement, per_side, h_over_dx, jitter, run.seed(), run.threads()};
    }
};

/// The same, and how many particles there are.
struct ParticleOptions : SmoothingOptions {
    long particles = 32;  // along each side of the box

    void declare(app::CommandLine& line);
    Setting setting(Arrangement arrangement, const report::Run& run) const {
        return SmoothingOptions::setting(arrangement, static_cast<std::size_t>(particles), run);
    }
};

}  // namespace sph::interpolation
