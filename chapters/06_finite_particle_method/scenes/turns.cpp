#include "chapters/06_finite_particle_method/scenes/turns.hpp"

#include <algorithm>
#include <limits>

namespace sph::fpm {

std::vector<double> timed_in_turns(const report::Run& run, const std::vector<std::function<void()>>& works) {
    const bool once = run.checking() || run.quick();
    constexpr double sample = 0.004;  // seconds: some hundred calls, and short beside what disturbs
    std::vector<double> least(works.size(), std::numeric_limits<double>::infinity());
    for (int round = 0; round < (once ? 1 : 12); ++round) {
        for (std::size_t k = 0; k < works.size(); ++k)
            least[k] = std::min(least[k], report::time(works[k], 1, once ? 0 : sample).best);
    }
    return least;
}

}  // namespace sph::fpm
