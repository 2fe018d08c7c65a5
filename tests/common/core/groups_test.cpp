#include "common/core/groups.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

using sph::Groups;
using Ranges = std::vector<std::pair<std::size_t, std::size_t>>;

namespace {

Ranges free_ranges(const Groups& groups, std::size_t n) {
    Ranges ranges;
    groups.for_each_free(n, [&](std::size_t begin, std::size_t end) { ranges.emplace_back(begin, end); });
    return ranges;
}

}  // namespace

TEST_CASE("all particles are free unless a group holds them") {
    // Fails if a range is empty, out of order, or runs into a group; groups may be named in any order.
    Groups groups;
    CHECK(free_ranges(groups, 10) == Ranges{{0, 10}});
    CHECK(groups.free(10) == 10);
    CHECK(free_ranges(groups, 0).empty());
    groups.hold("right wall", 8, 10);
    groups.hold("body", 3, 5);
    CHECK(free_ranges(groups, 10) == Ranges{{0, 3}, {5, 8}});
    CHECK(groups.free(10) == 6);
    groups.hold("left wall", 0, 2);
    groups.hold("mast", 5, 6);
    CHECK(free_ranges(groups, 12) == Ranges{{2, 3}, {6, 8}, {10, 12}});
    CHECK(groups.free(12) == 5);
    CHECK(groups.held().size() == 4);
    CHECK(groups.held().front().name == "left wall");
    CHECK(groups.named("body").begin == 3);
    CHECK(groups.named("body").end == 5);
}

TEST_CASE("groups of particles that do not exist yet hold nothing") {
    // Fails if the ranges of free particles go beyond the particles.
    Groups groups;
    groups.hold("later", 6, 9);
    CHECK(free_ranges(groups, 4) == Ranges{{0, 4}});
    CHECK(free_ranges(groups, 7) == Ranges{{0, 6}});
}

TEST_CASE("groups that contradict each other are refused by name") {
    // Each line fails if its check is left out: a particle would be in two groups.
    Groups groups;
    groups.hold("wall", 4, 8);
    CHECK_THROWS_WITH(groups.hold("none", 3, 3), "group none: no particles");
    CHECK_THROWS_WITH(groups.hold("wall", 0, 1), "group wall: the name is taken");
    CHECK_THROWS_WITH(groups.hold("a", 7, 9), "group a overlaps group wall");
    CHECK_THROWS_WITH(groups.hold("b", 0, 5), "group b overlaps group wall");
    CHECK_THROWS_WITH(groups.hold("c", 5, 6), "group c overlaps group wall");
    CHECK_THROWS_AS(groups.hold("d", 9, 2), std::invalid_argument);
    CHECK_NOTHROW(groups.hold("left", 0, 4));
    CHECK_NOTHROW(groups.hold("right", 8, 9));
    CHECK_THROWS_WITH(groups.named("middle"), "no group middle");
    CHECK(groups.held().size() == 3);
}
