#include "common/app/parallel.hpp"

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

namespace app {

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t)>& body) {
    if (threads < 1) throw std::invalid_argument{"parallel_for: threads < 1"};
    if (count == 0) return;
    const std::size_t parts = std::min(count, static_cast<std::size_t>(threads));
    // Part k is [start(k), start(k + 1)): lengths differ by at most one, and no product can overflow.
    const auto start = [&](std::size_t k) { return k * (count / parts) + std::min(k, count % parts); };
    std::vector<std::exception_ptr> failures(parts);
    const auto run_part = [&](std::size_t k) {
        try {
            body(start(k), start(k + 1));
        } catch (...) {
            failures[k] = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> helpers;  // joined at the end of this block
        helpers.reserve(parts - 1);
        for (std::size_t k = 1; k < parts; ++k) {
            try {
                helpers.emplace_back(run_part, k);
            } catch (const std::system_error&) {
                run_part(k);  // no thread to be had: slower, but the same result
            }
        }
        run_part(0);
    }
    // The first part's exception, not the earliest: which one is seen must not depend on timing.
    for (const auto& failure : failures) {
        if (failure) std::rethrow_exception(failure);
    }
}

}  // namespace app
