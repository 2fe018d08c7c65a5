#include "common/exact/woodward_colella.hpp"

#include <fmt/format.h>

#include <iterator>

#include "common/app/error.hpp"
#include "common/app/program.hpp"
#include "common/exact/program/csv.hpp"
#include "common/exact/program/points.hpp"
#include "common/exact/program/solutions.hpp"

namespace exact::program {
namespace {

class WoodwardColellaSolution : public Solution {
  public:
    std::string name() const override { return "woodward-colella"; }
    std::string description() const override {
        return "the interacting blast waves, a numerical reference at t = 0.038: x,rho,v,p,u";
    }

    void declare(app::CommandLine& command) override {
        points_.declare(command, "positions");
        command.integer("cells", cells_, 10, 1'000'000,
                        "computes the solution with this many cells instead of printing the stored one; "
                        "four minutes for 51200, as the square of them");
        command.flag("table", table_, "with --cells: prints common/exact/woodward_colella_table.cpp instead");
        command.footer(
            "Example: exact woodward-colella --points 501 --window 0.5,0.9\n"
            "The stored solution is that of --cells 51200.");
    }

    std::string csv(const app::CommandLine& command) const override {
        const bool computed = command.given("cells");
        if (table_ && !computed) throw app::UsageError{"--table: goes with --cells N"};
        if (table_ && (command.given("x") || command.given("points")))
            throw app::UsageError{"--table: prints its own points; give neither --x nor --points"};
        const auto points = table_ ? std::vector<double>{} : points_.values(command);
        const auto cells = static_cast<std::size_t>(cells_);
        const WoodwardColella solution =
            computed ? WoodwardColella{cells, app::check_interrupt} : WoodwardColella{};
        if (table_) return source(solution);
        Csv csv;
        csv.parameter("cells", static_cast<double>(solution.cells()));
        csv.parameter("gamma", WoodwardColella::gamma).parameter("time", WoodwardColella::time);
        csv.columns("x,rho,v,p,u");
        for (const double x : points) {
            const auto [rho, v, p, u] = solution.at(x);
            csv.row({x, rho, v, p, u});
        }
        return csv.text();
    }

  private:
    static constexpr double tolerance = 2e-4;  // of the lines between the points of the table

    static std::string source(const WoodwardColella& solution) {
        std::string text = fmt::format(
            "// exact woodward-colella --cells {0} --table\n"
            "#include \"common/exact/woodward_colella_table.hpp\"\n\n"
            "namespace exact {{\nnamespace {{\n\n"
            "// clang-format off\n"
            "constexpr WoodwardColella::Node table[] = {{  // x, rho, v, p\n",
            solution.cells());
        for (const auto& [x, rho, v, p] : solution.thinned(tolerance))
            fmt::format_to(std::back_inserter(text), "    {{{:.9g}, {:.7g}, {:.7g}, {:.7g}}},\n", x, rho, v,
                           p);
        text += fmt::format(
            "}};\n// clang-format on\n\n}}  // namespace\n\n"
            "std::span<const WoodwardColella::Node> woodward_colella_table() {{\n    return table;\n}}\n\n"
            "std::size_t woodward_colella_table_cells() {{\n    return {};\n}}\n\n}}  // namespace exact\n",
            solution.cells());
        return text;
    }

    Points points_{"x", {0, 1}, {0, 1}};
    long cells_ = 51200;
    bool table_ = false;
};

}  // namespace

std::unique_ptr<Solution> woodward_colella() {
    return std::make_unique<WoodwardColellaSolution>();
}

}  // namespace exact::program
