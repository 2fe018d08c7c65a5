#include "common/app/team.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

namespace app {
namespace {

/// Waits until `value` differs from `old`. Passes follow each other closely, so it looks a while before it
/// lets the thread sleep: waking one takes longer than a short pass.
template <class T>
void wait_while(const std::atomic<T>& value, T old) {
    constexpr int looks = 20000;  // about a quarter of a millisecond
    for (int k = 0; k < looks; ++k) {
        if (value.load(std::memory_order_acquire) != old) return;
#if defined(__x86_64__)
        __builtin_ia32_pause();
#endif
    }
    while (value.load(std::memory_order_acquire) == old) value.wait(old, std::memory_order_acquire);
}

}  // namespace

struct Team::Members {
    std::vector<std::exception_ptr> failures;
    std::atomic<unsigned> round{0};          // a new one begins when it changes
    std::atomic<std::size_t> unfinished{0};  // helpers of this round
    bool closing = false;
    std::size_t parts = 0;
    void (*call)(void*, std::size_t) = nullptr;
    void* work = nullptr;
    std::vector<std::jthread> helpers;  // last: joined before anything that they use goes

    explicit Members(int threads) {
        helpers.reserve(static_cast<std::size_t>(threads) - 1);
        for (int k = 1; k < threads; ++k) {
            try {
                helpers.emplace_back([this, part = static_cast<std::size_t>(k)] { help(part); });
            } catch (const std::system_error&) {
                break;  // no more threads to be had: slower, but the same result
            }
        }
        failures.resize(helpers.size() + 1);
    }
    ~Members() {
        closing = true;
        begin_round();
    }
    void begin_round() {
        round.fetch_add(1, std::memory_order_release);
        round.notify_all();
    }
    void do_part(std::size_t part) noexcept {
        try {
            if (part < parts) call(work, part);
        } catch (...) {
            failures[part] = std::current_exception();
        }
    }
    void help(std::size_t part) {
        for (unsigned seen = 0;;) {
            wait_while(round, seen);
            seen = round.load(std::memory_order_acquire);
            if (closing) return;
            do_part(part);
            if (unfinished.fetch_sub(1, std::memory_order_acq_rel) == 1) unfinished.notify_one();
        }
    }
};

Team::Team(int threads) {
    if (threads < 1) throw std::invalid_argument{"Team: threads < 1"};
    if (threads > 1) members_ = std::make_unique<Members>(threads);
}
Team::~Team() = default;
Team::Team(Team&&) noexcept = default;
Team& Team::operator=(Team&&) noexcept = default;

int Team::size() const noexcept {
    return members_ ? static_cast<int>(members_->helpers.size()) + 1 : 1;
}

void Team::run(std::size_t parts, void (*call)(void*, std::size_t), void* work) {
    if (parts > static_cast<std::size_t>(size()))
        throw std::invalid_argument{"Team: more parts than members"};
    Members& m = *members_;
    m.parts = parts;
    m.call = call;
    m.work = work;
    std::fill(m.failures.begin(), m.failures.end(), nullptr);
    m.unfinished.store(m.helpers.size(), std::memory_order_relaxed);
    m.begin_round();
    m.do_part(0);
    for (std::size_t left = m.unfinished.load(); left > 0; left = m.unfinished.load())
        wait_while(m.unfinished, left);
    // The first part's exception, not the earliest: which one is seen must not depend on timing.
    for (const auto& failure : m.failures) {
        if (failure) std::rethrow_exception(failure);
    }
}

}  // namespace app
