#include "chapters/02_consistency/scenes/jump_line.hpp"

#include <stdexcept>

#include "chapters/02_consistency/discontinuity.hpp"
#include "chapters/02_consistency/scenes/cloud.hpp"
#include "common/report/norms.hpp"

namespace sph::consistency {

const JumpScheme& JumpLine::scheme(const std::string& name) const {
    for (const JumpScheme& one : schemes) {
        if (one.name == name) return one;
    }
    throw std::out_of_range{"no scheme " + name};
}

JumpLine line_with_jump(const Function<1>& function, double jump_at, std::size_t n, double jitter,
                        std::uint64_t seed, int threads) {
    const ParticleSet set{.arrangement = Arrangement::jittered,
                          .per_side = n,
                          .jitter = jitter,
                          .seed = seed,
                          .threads = threads};
    auto cloud = cloud_of<1, Value, DifferenceGradient, Shepard, MatrixGradient<>, BeyondJump,
                          DiscontinuousFit, OneSidedFit>(set, function);
    const Jump jump = Jump::find(jump_at, cloud.particles().x[0], cloud.particles().A);
    const auto& p = cloud.estimate(Effects{Value{}, DifferenceGradient{}, Shepard{}, MatrixGradient<>{},
                                           BeyondJump{jump}, DiscontinuousFit{jump}, OneSidedFit{}});
    JumpLine line{jump_at, p.x[0], p.A, {}, {}};
    for (const double x : line.x) line.exact_slope.push_back(function.gradient({x})[0]);
    line.schemes = {{"sph", "SPH", p.value, p.gradient[0]},
                    {"cspm", "CSPM", p.shepard, p.matrix[0]},
                    {"dsph", "DSPH", p.dsph[0], p.dsph[1]},
                    {"one-sided", "one side", p.one_sided[0], p.one_sided[1]}};
    return line;
}

JumpErrors errors_near_jump(const JumpLine& line, const JumpScheme& scheme, double width) {
    report::SquaredError value, slope;
    for (std::size_t i = 0; i < line.x.size(); ++i) {
        if (std::abs(line.x[i] - line.jump) > width) continue;
        value.add(scheme.value[i], line.exact[i]);
        slope.add(scheme.slope[i], line.exact_slope[i]);
    }
    return {value.relative(), slope.relative()};
}

}  // namespace sph::consistency
