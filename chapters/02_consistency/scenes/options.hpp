#pragma once
#include "chapters/02_consistency/scenes/measured.hpp"
#include "common/report/chapter.hpp"

/// What a reader chooses for this chapter's figures and scene.
namespace sph::consistency {

struct KernelOptions {
    std::string kernel = "quintic";
    double h_over_dx = 1.2;

    void declare(app::CommandLine& line);
};

/// The same, and what the particles are like.
struct ParticleSetOptions : KernelOptions {
    double jitter = 0.2;  // [spacings]
    std::string volumes = "summed";

    void declare(app::CommandLine& line);
    ParticleSet set(Arrangement arrangement, std::size_t per_side, const report::Run& run) const {
        const Volumes kind = volumes == "equal" ? Volumes::equal : Volumes::summed;
        return {kernel, arrangement, per_side, h_over_dx, jitter, run.seed(), kind, run.threads()};
    }
};

}  // namespace sph::consistency
