// Options that this run does not take, but others do.
#include <catch2/catch.hpp>

#include "common/app/command_line.hpp"
#include "common/app/error.hpp"
#include "tests/common/app/child.hpp"

namespace {

/// A program that takes --gamma itself and knows that others take --gamma, --length and --fast.
struct Choosy {
    double gamma = 1.4, other_gamma = 2, length = 1;
    bool fast = false;
    app::CommandLine line{"program", "text"};

    Choosy() {
        line.number("gamma", gamma, app::positive, "", "adiabatic index");
        line.foreign();
        line.number("gamma", other_gamma, app::positive, "", "of another one")
            .number("length", length, app::positive, "L", "of a box")
            .flag("fast", fast, "in a hurry");
    }
    std::vector<std::string> refused(std::vector<std::string> words) {
        const child::Arguments arguments{std::move(words)};
        return line.parse(arguments.count(), arguments.values()) ? line.refused()
                                                                 : std::vector<std::string>{"not run"};
    }
};

}  // namespace

TEST_CASE("foreign options are known, checked, and refused by name") {
    // Fails if the second declaration of a name takes the value away from the first, or if a foreign option
    // is unknown.
    using Refused = std::vector<std::string>;
    CHECK(Choosy{}.refused({}).empty());
    CHECK(Choosy{}.refused({"--gamma", "3"}).empty());
    CHECK(Choosy{}.refused({"--fast", "--length=2", "--gamma", "3"}) == Refused{"--length", "--fast"});
    CHECK_THROWS_WITH(Choosy{}.refused({"--length", "0"}), "--length: 0 is not allowed; allowed: > 0");
    CHECK_THROWS_WITH(Choosy{}.refused({"--lenght", "1"}), "unknown option --lenght; did you mean --length?");
    Choosy program;
    program.refused({"--gamma", "3"});
    CHECK(program.gamma == 3);
    CHECK(program.other_gamma == 2);
}

TEST_CASE("only the own options are entries of --help") {
    // Fails if foreign ones are listed twice: among the own and where --help tells of their takers.
    const Choosy program;
    CHECK(program.line.entries() == "  --gamma X                 adiabatic index; > 0; default 1.4\n");
    CHECK(program.line.names() == std::vector<std::string>{"gamma", "length", "fast"});
    const auto help = child::run([] {
        Choosy helped;
        helped.refused({"--help"});
        return 0;
    });
    CHECK_THAT(help.out, Catch::Contains("--gamma X") && !Catch::Contains("--length") &&
                             !Catch::Contains("--fast") && !Catch::Contains("of another one"));
}
