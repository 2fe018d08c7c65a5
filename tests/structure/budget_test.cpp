// What a chapter may cost to compile. Each different pass over the neighbours is a loop of its own, with all
// of its effects inlined: the compiler's time goes there. So a chapter may have forty of them.
#include <catch2/catch.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "tests/structure/tracked.hpp"

namespace {

using structure::output_of;

/// The passes that a list of symbols names, as nm prints them.
std::set<std::string> passes_of(const std::string& symbols) {
    const std::regex pass{R"(sum_receivers(?:_inlined)?<(.*)>\(sph::pass_detail::Sum<)"};
    std::set<std::string> found;
    std::istringstream lines{symbols};
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (std::regex_search(line, match, pass)) found.insert(match[1]);
    }
    return found;
}

}  // namespace

TEST_CASE("a chapter has at most forty passes") {
    std::istringstream libraries{SPH_CHAPTER_LIBRARIES};
    std::size_t most = 0;
    for (std::string library; std::getline(libraries, library, ',');) {
        const auto passes = passes_of(output_of("nm -C '" + library + "' 2>/dev/null"));
        INFO(library);
        CHECK(passes.size() <= 40);
        most = std::max(most, passes.size());
    }
    CHECK(most > 10);  // they were found
}
