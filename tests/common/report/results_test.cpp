#include "common/report/results.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "common/app/files.hpp"
#include "tests/common/app/child.hpp"

using report::Results;

namespace {

std::vector<std::string> scenes(const Results& results) {
    std::vector<std::string> names;
    for (const auto& row : results.rows()) names.push_back(row.scene);
    return names;
}
using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("results survive writing and reading, bit by bit") {
    // Fails with one digit less, or if a locale or a float is in between.
    Results results;
    const double largest = std::numeric_limits<double>::max(),
                 smallest = std::numeric_limits<double>::denorm_min();
    for (const double value : {0.1, 1.0 / 3, -0.0, largest, smallest, 1e22, 5e-324, 123456789.0})
        results.add("tube", "sph", 100, "l1_rho", value, "1");
    results.add("", "", -5, "", 1, "");
    const child::Folder folder;
    results.write(folder.path() / "results.csv");
    const Results again = Results::parse(app::read_file(folder.path() / "results.csv"));
    REQUIRE(again.rows().size() == results.rows().size());
    for (std::size_t k = 0; k < again.rows().size(); ++k) {
        const auto bits = [k](const Results& r) { return std::bit_cast<std::uint64_t>(r.rows()[k].value); };
        CHECK(bits(again) == bits(results));
        CHECK(again.rows()[k].n == results.rows()[k].n);
        CHECK(again.rows()[k].unit == results.rows()[k].unit);
    }
    CHECK(again.csv() == results.csv());
    CHECK(results.csv().starts_with(
        "scene,method,n,quantity,value,unit\ntube,sph,100,l1_rho,0.1000000000000000"));
}

TEST_CASE("what is not a measured number is refused") {
    // Each line fails if its check is left out.
    Results results;
    CHECK_THROWS_AS(results.add("a", "b", 1, "q", std::nan("")), std::invalid_argument);
    CHECK_THROWS_AS(results.add("a", "b", 1, "q", std::numeric_limits<double>::infinity()),
                    std::invalid_argument);
    CHECK_THROWS_AS(results.add("a,b", "b", 1, "q", 1), std::invalid_argument);
    CHECK_THROWS_AS(results.add("a", "\"b\"", 1, "q", 1), std::invalid_argument);
    CHECK_THROWS_AS(results.add("a", "b", 1, "q\n", 1), std::invalid_argument);
    CHECK_THROWS_AS(results.add("a", "b", 1, "q", 1, "m,s"), std::invalid_argument);
    CHECK(results.rows().empty());
}

TEST_CASE("one value is found, and a wrong name is named") {
    // Fails if a part of the key is not compared.
    Results results;
    results.add("tube", "sph", 100, "l1_rho", 0.5);
    results.add("tube", "sph", 200, "l1_rho", 0.25);
    results.add("tube", "sph", 200, "l1_v", 0.125);
    CHECK(results.value("tube", "sph", 200, "l1_rho") == 0.25);
    CHECK_THROWS_WITH(results.value("tube", "sph", 300, "l1_rho"), "results: no tube,sph,300,l1_rho");
    CHECK_THROWS_AS(results.value("tub", "sph", 200, "l1_rho"), std::out_of_range);
    results.add("tube", "sph", 200, "l1_v", 0.125);
    CHECK_THROWS_AS(results.value("tube", "sph", 200, "l1_v"), std::out_of_range);
}

TEST_CASE("a faulty file is refused, with its line") {
    // Fails if the number of cells, a number's end or the header is not checked.
    const std::string header = "scene,method,n,quantity,value,unit\n";
    const Results none = Results::parse(header);
    CHECK(none.rows().empty());
    const Results one = Results::parse("scene,method,n,quantity,value,unit\r\na,b,1,q,2,1\r\n");
    CHECK(one.rows()[0].unit == "1");
    CHECK_THROWS_WITH(Results::parse(""), Catch::StartsWith("line 1: the header"));
    CHECK_THROWS_WITH(Results::parse("a,b\n"), Catch::StartsWith("line 1: the header"));
    CHECK_THROWS_WITH(Results::parse(header + "a,b,1,q,2,1\na,b,1,q,2\n"), "line 3: six values are needed");
    CHECK_THROWS_WITH(Results::parse(header + "a,b,1.5,q,2,1\n"), "line 2: n is not a whole number");
    CHECK_THROWS_WITH(Results::parse(header + "a,b,1,q,2x,1\n"), "line 2: the value is not a number");
    CHECK_THROWS_WITH(Results::parse(header + "a,b,1,q,nan,1\n"), Catch::StartsWith("line 2:"));
    CHECK_THROWS_WITH(Results::parse(header + "\n"), "line 2: six values are needed");
}

TEST_CASE("a new scene replaces its older rows and keeps the others', and its own of other sizes") {
    // Fails if rows of other parameters stay, and if those of another N do not.
    Results older, results;
    older.add("a", "m", 1, "q", 1);
    older.add("b", "m", 1, "q", 2);
    older.add("b", "m", 2, "q", 3);
    results.add("b", "m", 1, "q", 4);
    results.add("c", "m", 1, "q", 5);
    Results others = results;
    results.parameters = {{"gamma", "2"}, {"particles", "1"}};
    older.parameters = {{"gamma", "2"}, {"particles", "2"}};
    results.merge_older(older);
    CHECK(scenes(results) == Names{"a", "b", "b", "c"});
    CHECK(results.value("b", "m", 1, "q") == 4);
    CHECK(results.value("b", "m", 2, "q") == 3);
    CHECK(Results::parse(results.csv()).parameters == results.parameters);
    others.parameters = {{"gamma", "3"}, {"particles", "1"}};
    others.merge_older(older);
    CHECK(scenes(others) == Names{"a", "b", "c"});
    results = others;
    results.append(older);
    results.sort_by_scene({"c", "b"});
    CHECK(scenes(results) == Names{"c", "b", "b", "b", "a", "a"});
    CHECK(results.rows()[1].value == 4);
}
