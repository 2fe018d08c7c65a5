#pragma once
#include <functional>
#include <vector>

#include "common/report/chapter.hpp"

/// Times that are to be compared with one another.
namespace sph::fpm {

/// CPU seconds of one call of each work: the least of twelve samples that are taken in turns, so that what
/// disturbs the machine for a while disturbs all of them. One call each where only the text is compared, or
/// in a quick run.
std::vector<double> timed_in_turns(const report::Run& run, const std::vector<std::function<void()>>& works);

}  // namespace sph::fpm
