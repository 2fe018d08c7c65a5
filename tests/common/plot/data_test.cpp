#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "common/plot/save.hpp"

using namespace plot;

namespace {

using Row = std::vector<std::string>;

/// RFC 4180: cells may be quoted, quotes are doubled.
std::vector<Row> parse(const std::string& csv) {
    std::vector<Row> rows(1, Row(1));
    bool quoted = false;
    for (std::size_t k = 0; k < csv.size(); ++k) {
        const char c = csv[k];
        if (c == '"' && quoted && k + 1 < csv.size() && csv[k + 1] == '"')
            rows.back().back() += csv[++k];
        else if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            rows.back().emplace_back();
        else if (c == '\n' && !quoted)
            rows.emplace_back(1);
        else
            rows.back().back() += c;
    }
    rows.pop_back();
    return rows;
}

double number(const std::string& cell) {
    return std::strtod(cell.c_str(), nullptr);
}

}  // namespace

TEST_CASE("every number of a figure comes back from its CSV to seven digits") {
    const Values x{0.1, 1.0 / 3, 1e-300, std::numeric_limits<double>::denorm_min()};
    const Values y{-0.7, 2e17 + 32, 5.0 / 7, -1e-17};
    Figure figure{"csv", 1, 2};
    figure.at(0, 0).curve(x, y, {.label = "a, \"quoted\"\nlabel"}).error = {0.25, 0.5, 1, 2};
    figure.at(0, 1).particles({.name = "p", .x = x, .y = y, .value = y});
    const auto rows = parse(data_csv(figure));
    // Fails with six significant digits or fewer, with unquoted labels, and if error and value are swapped.
    // More than seven would only make files grow: no drawing shows them.
    const auto same = [](const std::string& cell, double value) {
        CHECK(cell.size() <= std::string{"-1.234567e-308"}.size());
        return std::abs(number(cell) - value) <= 0.5001e-6 * std::abs(value);
    };
    REQUIRE(rows.size() == 9);
    CHECK(rows[0] == Row{"panel", "kind", "label", "x", "y", "value", "error"});
    CHECK(rows[2][3] == "0.3333333");
    CHECK(rows[1][3] == "0.1");
    for (std::size_t k = 0; k < 4; ++k) {
        const Row& curve = rows[1 + k];
        CHECK(curve[0] == "a");
        CHECK(curve[1] == "curve");
        CHECK(curve[2] == "a, \"quoted\"\nlabel");
        if (k < 3) CHECK(same(curve[3], x[k]));
        CHECK(same(curve[4], y[k]));
        CHECK(curve[5].empty());
        CHECK(same(curve[6], figure.at(0, 0).curves[0].error[k]));
        const Row& disc = rows[5 + k];
        CHECK(disc[0] == "b");
        CHECK(disc[1] == "disc");
        CHECK(same(disc[5], y[k]));
        CHECK(disc[6].empty());
    }
    CHECK(number(rows[4][3]) > 0);  // the smallest number of all has one digit only
}

TEST_CASE("bands, fields and arrows have a row for each number they show") {
    Figure figure{"csv"};
    figure.panel().band({1, 2}, {3, 4}, {5, 6}, "band");
    figure.panel().field({.name = "f", .x = {1, 2, 3}, .y = {10, 20}, .value = {1, 2, 3, 4, 5, 6}});
    figure.panel().vectors({.name = "v", .x = {1}, .y = {2}, .u = {3}, .v = {4}});
    const auto rows = parse(data_csv(figure));
    REQUIRE(rows.size() == 1 + 4 + 6 + 2);
    CHECK(rows[1] == Row{"a", "band low", "band", "1", "3", "", ""});
    CHECK(rows[4] == Row{"a", "band high", "band", "2", "6", "", ""});
    // Fails if rows and columns of the field are exchanged.
    CHECK(rows[8] == Row{"a", "field", "f", "1", "20", "4", ""});
    CHECK(rows[11] == Row{"a", "arrow u", "v", "1", "2", "3", ""});
    CHECK(rows[12] == Row{"a", "arrow v", "v", "1", "2", "4", ""});
}
