#include "common/app/team.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

TEST_CASE("every element is computed once, and the same for any number of threads") {
    // Fails if parts overlap, leave a gap, or depend on the number of threads; many rounds, because a team
    // that loses a round hangs or repeats one.
    const std::size_t count = 1003;
    std::vector<double> expected;
    for (const int threads : {1, 2, 3, 7, 64}) {
        app::Team team{threads};
        CHECK(team.size() == threads);
        for (int round = 0; round < 50; ++round) {
            std::vector<double> result(count);
            std::vector<int> visits(count);
            team.parallel_for(
                count,
                [&](std::size_t begin, std::size_t end) {
                    for (std::size_t i = begin; i < end; ++i) {
                        result[i] = std::sin(static_cast<double>(i));
                        ++visits[i];
                    }
                },
                1);
            REQUIRE(visits == std::vector<int>(count, 1));
            if (expected.empty()) expected = result;
            REQUIRE(result == expected);
        }
    }
}

TEST_CASE("parts are at most as many as members, not shorter than the grain, and equal but for one element") {
    // Fails if the remainder all goes to one thread, if empty parts are called, or if short work is divided.
    app::Team team{4};
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{3}, std::size_t{10}}) {
        for (const std::size_t grain : {std::size_t{1}, std::size_t{5}}) {
            std::mutex mutex;
            std::vector<std::size_t> lengths;
            team.parallel_for(
                count,
                [&](std::size_t begin, std::size_t end) {
                    const std::lock_guard lock{mutex};
                    lengths.push_back(end - begin);
                },
                grain);
            const std::size_t parts =
                count == 0 ? 0 : std::max<std::size_t>(1, std::min<std::size_t>(count / grain, 4));
            CHECK(lengths.size() == parts);
            for (const std::size_t length : lengths)
                CHECK((length == count / parts || length == count / parts + 1));
        }
    }
}

TEST_CASE("a team of one is the caller") {
    // Fails if a thread is started for nothing.
    std::thread::id id;
    app::Team{}.parallel_for(5000, [&](std::size_t, std::size_t) { id = std::this_thread::get_id(); });
    CHECK(id == std::this_thread::get_id());
}

TEST_CASE("an exception comes out after all parts have ended, the first part's first") {
    // Fails if an exception ends the program, is lost, depends on which thread is faster, or stays for the
    // next round.
    app::Team team{4};
    for (int repeat = 0; repeat < 20; ++repeat) {
        std::vector<int> visits(8);
        const auto work = [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) visits[i] = 1;
            if (begin > 0) throw std::runtime_error{std::to_string(begin)};
        };
        CHECK_THROWS_WITH(team.parallel_for(8, work, 1), "2");
        CHECK(visits == std::vector<int>(8, 1));
        CHECK_NOTHROW(team.parallel_for(
            8, [](std::size_t, std::size_t) {}, 1));
    }
    CHECK_THROWS_AS(app::Team{0}, std::invalid_argument);
    CHECK_THROWS_AS(team.for_each_part(5, [](std::size_t) {}), std::invalid_argument);
}
