#pragma once
#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace app {

/// Threads that stay: starting one for every pass over the particles would cost more than a small pass, and
/// would allocate. Which part of the work a member gets never depends on timing, and as long as element i of
/// a result is computed from inputs alone, the result is bitwise the same for any number of threads.
class Team {
  public:
    /// `threads` >= 1, the caller's included. If the system has fewer to give, the team is smaller.
    explicit Team(int threads = 1);
    ~Team();
    Team(Team&&) noexcept;
    Team& operator=(Team&&) noexcept;

    int size() const noexcept;

    /// Calls body(begin, end) or body(begin, end, part) on disjoint parts that cover 0..count, at most one a
    /// member, and returns when all have ended. Parts shorter than `grain` are not worth waking a thread for:
    /// there are fewer then. An exception of `body` is thrown again here, that of the first part if there are
    /// several. Allocates nothing. Not to be called from within `body`.
    template <class Body>
    void parallel_for(std::size_t count, Body&& body, std::size_t grain = 512) {
        if (count == 0) return;
        const std::size_t parts = std::clamp<std::size_t>(count / std::max<std::size_t>(grain, 1), 1,
                                                          static_cast<std::size_t>(size()));
        for_each_part(parts, [&](std::size_t part) {
            // Lengths differ by at most one, and no product can overflow.
            const auto start = [&](std::size_t k) {
                return k * (count / parts) + std::min(k, count % parts);
            };
            if constexpr (std::is_invocable_v<Body&, std::size_t, std::size_t, std::size_t>) {
                body(start(part), start(part + 1), part);
            } else {
                body(start(part), start(part + 1));
            }
        });
    }

    /// Calls body(part) for part = 0 .. parts - 1, each on a thread of its own; parts <= size().
    template <class Body>
    void for_each_part(std::size_t parts, Body&& body) {
        if (parts == 1) return body(std::size_t{0});
        using B = std::remove_reference_t<Body>;
        run(
            parts, [](void* work, std::size_t part) { (*static_cast<B*>(work))(part); },
            const_cast<std::remove_const_t<B>*>(&body));
    }

  private:
    void run(std::size_t parts, void (*call)(void*, std::size_t), void* work);
    struct Members;
    std::unique_ptr<Members> members_;  // none for a team of one
};

}  // namespace app
