#include "common/app/parallel.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

TEST_CASE("every element is computed once, and the same for any number of threads") {
    // Fails if parts overlap, leave a gap, or depend on the number of threads.
    const std::size_t count = 1003;
    std::vector<double> expected;
    for (const int threads : {1, 2, 3, 7, 256}) {
        std::vector<double> result(count);
        std::vector<int> visits(count);
        app::parallel_for(count, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                result[i] = std::sin(static_cast<double>(i));
                ++visits[i];
            }
        });
        CHECK(visits == std::vector<int>(count, 1));
        if (expected.empty()) expected = result;
        CHECK(result == expected);
    }
}

TEST_CASE("parts are as many as threads and differ by at most one element") {
    // Fails if the remainder all goes to one thread, or if empty parts are called.
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{3}, std::size_t{10}}) {
        std::mutex mutex;
        std::vector<std::size_t> lengths;
        app::parallel_for(count, 4, [&](std::size_t begin, std::size_t end) {
            const std::lock_guard lock{mutex};
            lengths.push_back(end - begin);
        });
        CHECK(lengths.size() == std::min<std::size_t>(count, 4));
        for (const std::size_t length : lengths) CHECK((length == count / 4 || length == count / 4 + 1));
    }
}

TEST_CASE("one thread is the caller's") {
    // Fails if a thread is started for nothing.
    std::thread::id id;
    app::parallel_for(5, 1, [&](std::size_t, std::size_t) { id = std::this_thread::get_id(); });
    CHECK(id == std::this_thread::get_id());
}

TEST_CASE("an exception comes out after all parts have ended, the first part's first") {
    // Fails if an exception ends the program, is lost, or depends on which thread is faster.
    for (int repeat = 0; repeat < 20; ++repeat) {
        std::vector<int> visits(8);
        const auto work = [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) visits[i] = 1;
            if (begin > 0) throw std::runtime_error{std::to_string(begin)};
        };
        CHECK_THROWS_WITH(app::parallel_for(8, 4, work), "2");
        CHECK(visits == std::vector<int>(8, 1));
    }
    CHECK_THROWS_AS(app::parallel_for(1, 0, [](std::size_t, std::size_t) {}), std::invalid_argument);
}
