#include "common/app/command_line.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <sstream>

#include "common/app/error.hpp"
#include "common/app/program.hpp"
#include "tests/common/app/child.hpp"

namespace {

/// A program with one option of each kind.
struct Program {
    double gamma = 1.4;
    long threads = 2;
    std::vector<double> left{1, 0, 1}, x;
    std::string method = "fast", out;
    bool quick = false;
    app::CommandLine line{"program", "Tests the options."};

    Program() {
        line.number("gamma", gamma, {1, 10, true, false}, "", "adiabatic index")
            .integer("threads", threads, 1, 256, "number of threads")
            .numbers("left", left, app::any, "", "density, velocity and pressure on the left", 3)
            .numbers("x", x, app::any, "L", "positions")
            .choice("method", method, {"fast", "slow", "exact"}, "how it is computed")
            .text("out", out, "DIR", "folder of the results")
            .flag("quick", quick, "fewer points");
    }
    bool parse(std::vector<std::string> words) {
        const child::Arguments arguments{std::move(words)};
        return line.parse(arguments.count(), arguments.values());
    }
};

std::string usage_error(std::vector<std::string> words) {
    try {
        Program program;
        static_cast<void>(program.parse(std::move(words)));
    } catch (const app::UsageError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("values reach their targets") {
    // Fails if an option writes into the wrong target, or if from_chars is replaced by a float's.
    Program program;
    REQUIRE(program.parse({"--gamma", "1.6666666666666667", "--threads=4", "--method", "slow", "--out", "a b",
                           "--quick", "--x", "1e-3,+2,.5"}));
    CHECK(program.gamma == 1.6666666666666667);
    CHECK(program.threads == 4);
    CHECK(program.method == "slow");
    CHECK(program.out == "a b");
    CHECK(program.quick);
    CHECK(program.x == std::vector<double>{1e-3, 2, 0.5});
    CHECK(program.line.given("threads"));
    CHECK_FALSE(program.line.given("left"));
}

TEST_CASE("values may begin with a minus sign") {
    // Fails if a word with a leading dash is taken for an option.
    const std::vector<std::vector<std::string>> lines{{"--left", "-1,2,-3", "--x", "-.5"},
                                                      {"--left=-1,2,-3", "--x=-.5"}};
    for (const auto& words : lines) {
        Program program;
        REQUIRE(program.parse(words));
        CHECK(program.left == std::vector<double>{-1, 2, -3});
        CHECK(program.x == std::vector<double>{-0.5});
    }
}

TEST_CASE("bad usage is answered with one line that names option, value and what is allowed") {
    // Each line fails if its check is left out; the texts fail if a part of the message is.
    using Words = std::vector<std::string>;
    const std::vector<std::pair<Words, std::string>> cases{
        {{"--threads", "0"}, "--threads: 0 is not allowed; allowed: 1..256"},
        {{"--threads", "257"}, "--threads: 257 is not allowed; allowed: 1..256"},
        {{"--threads", "1.5"}, "--threads: 1.5 is not a whole number; allowed: 1..256"},
        {{"--threads", "99999999999999999999"},
         "--threads: 99999999999999999999 is not allowed; allowed: 1..256"},
        {{"--gamma", "1"}, "--gamma: 1 is not allowed; allowed: > 1 and <= 10"},
        {{"--gamma", "nan"}, "--gamma: nan is not a finite number; allowed: > 1 and <= 10"},
        {{"--x", "-inf"}, "--x: -inf is not a finite number; allowed: any finite number"},
        {{"--gamma", "1e999"},
         "--gamma: 1e999 is too large or too small for a number; allowed: > 1 and <= 10"},
        {{"--gamma", "1.5x"}, "--gamma: 1.5x is not a number; allowed: > 1 and <= 10"},
        {{"--gamma", ""}, "--gamma: '' is not a number; allowed: > 1 and <= 10"},
        {{"--gamma"}, "--gamma: a value is missing"},
        {{"--gamma="}, "--gamma: a value is missing"},
        {{"--gamma=", "2"}, "--gamma: a value is missing"},
        {{"--gamma", "--quick"}, "--gamma: a value is missing before --quick"},
        {{"--x", ""}, "--x: the list is empty; values are separated by commas"},
        {{"--x", "1,,2"}, "--x: a value is missing between the commas of 1,,2"},
        {{"--x", "1,2,"}, "--x: a value is missing between the commas of 1,2,"},
        {{"--x", "1,b"}, "--x: b is not a number; allowed: any finite number"},
        {{"--left", "1,2"}, "--left: 1,2 has 2 values; allowed: exactly 3, separated by commas"},
        {{"--left", "1,2,3,4"}, "--left: 1,2,3,4 has 4 values; allowed: exactly 3, separated by commas"},
        {{"--method", "fsat"}, "--method: fsat is not known, did you mean fast?; allowed: fast, slow, exact"},
        {{"--method", "zzzz"}, "--method: zzzz is not known; allowed: fast, slow, exact"},
        {{"--out", ""}, "--out: a value is missing"},
        {{"--quick", "--quick"}, "--quick: given more than once"},
        {{"--gamma", "2", "--gamma", "2"}, "--gamma: given more than once"},
        {{"--quick=3"}, "--quick: takes no value"},
        {{"--quick", "3"}, "unexpected word 3; --help lists the options"},
        {{"stray"}, "unexpected word stray; --help lists the options"},
        {{"--hlep"}, "unknown option --hlep; did you mean --help?"},
        {{"--thread", "3"}, "unknown option --thread; did you mean --threads?"},
        {{"--zzzzzz=3"}, "unknown option --zzzzzz; --help lists the options"},
        {{"-q"}, "unknown option -q; --help lists the options"},
        {{"--"}, "unknown option --; --help lists the options"},
    };
    for (const auto& [words, message] : cases) CHECK(usage_error(words) == message);
}

TEST_CASE("bad usage ends a program with status 2 and one line on stderr") {
    // Fails if run() forgets the error's own status, or if a newline of the value gets through.
    const auto outcome = child::run([] {
        return app::run([] {
            Program program;
            static_cast<void>(program.parse({"--x", "1\n2"}));
        });
    });
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err == "error: --x: '1 2' is not a number; allowed: any finite number\n");
}

TEST_CASE("the option --help prints each option with meaning, unit, range and default") {
    // Fails if a part is dropped, a line is not wrapped, or help is not on standard output.
    const auto outcome = child::run([] {
        return app::run([] {
            Program program;
            const std::string long_text(40, 'w');
            double length = 0.25;
            program.line.number("length", length, app::positive, "dx",
                                long_text + " " + long_text + " " + long_text);
            program.line.footer("The end.");
            if (program.parse({"--help"})) throw std::runtime_error{"goes on after --help"};
        });
    });
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    CHECK_THAT(outcome.out, Catch::Contains("adiabatic index; > 1 and <= 10; default 1.4\n"));
    CHECK_THAT(outcome.out,
               Catch::Contains("--threads N               number of threads; 1..256; default 2\n"));
    CHECK_THAT(outcome.out, Catch::Contains("[dx]; > 0; default 0.25\n"));
    CHECK_THAT(outcome.out, Catch::Contains("how it is computed; one of fast, slow, exact; default fast\n"));
    CHECK_THAT(outcome.out, Catch::Contains("positions [L]; any finite number\n"));
    CHECK_THAT(outcome.out, Catch::EndsWith("The end.\n"));
    std::istringstream lines{outcome.out};
    for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 96);
}

TEST_CASE("the option --version prints the project's version") {
    // Fails if the version of CMake's project() does not reach the program.
    const auto outcome = child::run([] {
        return app::run([] {
            Program program;
            static_cast<void>(program.parse({"--version"}));
        });
    });
    CHECK(outcome.status == 0);
    CHECK(outcome.out == app::version() + "\n");
    CHECK(app::version().find_first_of("0123456789") != std::string::npos);
}

TEST_CASE("the changed options can be typed again") {
    // Fails if a default is listed, if a value loses digits, or if a word with a space is not quoted.
    Program program;
    REQUIRE(program.parse(
        {"--out", "it's a", "--quick", "--gamma", "1.1", "--threads", "2", "--left", "-1,0.1,3"}));
    CHECK(program.line.changed() == "--gamma 1.1 --left -1,0.1,3 --out 'it'\\''s a' --quick");
    CHECK(program.line.changed({"out", "quick"}) == "--gamma 1.1 --left -1,0.1,3");
    Program untouched;
    REQUIRE(untouched.parse({}));
    CHECK(untouched.line.changed().empty());
}

TEST_CASE("sub-commands have their own options") {
    // Fails if an option of one command is known to the other, or if no command at all is accepted.
    double time = 1, gamma = 1.4;
    const auto parse = [&](std::vector<std::string> words) {
        app::CommandLine line{"exact", "Exact solutions."};
        line.command("burgers", "viscous Burgers").number("time", time, app::positive, "T", "time");
        line.command("riemann", "Riemann problem").number("gamma", gamma, {1, 2, true, false}, "", "index");
        const child::Arguments arguments{std::move(words)};
        try {
            return line.parse(arguments.count(), arguments.values()) ? line.chosen_command() : "help";
        } catch (const app::UsageError& error) {
            return std::string{error.what()};
        }
    };
    CHECK(parse({"burgers", "--time", "3"}) == "burgers");
    CHECK(time == 3);
    CHECK(parse({"riemann", "--gamma=1.5"}) == "riemann");
    CHECK(gamma == 1.5);
    CHECK(parse({"burgers", "--gamma", "1.5"}) == "unknown option --gamma; --help lists the options");
    CHECK(parse({"burgers", "--tmie", "1.5"}) == "unknown option --tmie; did you mean --time?");
    CHECK(parse({"burgers", "riemann"}) == "unexpected word riemann; --help lists the options");
    CHECK(parse({"burger"}) == "unknown command burger; did you mean burgers?");
    CHECK(parse({"zzzzzzz"}) == "unknown command zzzzzzz; known: burgers, riemann");
    CHECK(parse({}) == "a command is missing; known: burgers, riemann");
    const auto help = child::run([&] { return parse({"burgers", "--help"}) == "help" ? 0 : 1; });
    CHECK(help.status == 0);
    CHECK_THAT(help.out, Catch::Contains("exact burgers") && Catch::Contains("time [T]; > 0") &&
                             !Catch::Contains("--gamma"));
}

TEST_CASE("ranges") {
    // Fails if an open end is taken for a closed one or infinity for a number.
    CHECK_FALSE(app::positive.contains(0));
    CHECK(app::non_negative.contains(0));
    CHECK_FALSE(app::any.contains(std::numeric_limits<double>::infinity()));
    CHECK_FALSE(app::any.contains(std::nan("")));
    CHECK(app::Range{0, 1}.text() == "0..1");
    CHECK(app::Range{1e-3, 10}.text() == "0.001..10");
    CHECK(app::positive.text() == "> 0");
    CHECK(app::non_negative.text() == ">= 0");
    CHECK(app::any.text() == "any finite number");
    CHECK(app::Range{0, 1, true, true}.text() == "> 0 and < 1");
}

TEST_CASE("a default that is not allowed is a mistake of the program") {
    // Fails if defaults are not checked: --help would contradict itself.
    app::CommandLine line{"program", "text"};
    double zero = 0, none = std::nan("");
    long many = 300;
    std::string method = "none";
    CHECK_THROWS_AS(line.number("a", zero, app::positive, "", ""), std::invalid_argument);
    CHECK_THROWS_AS(line.integer("b", many, 1, 256, ""), std::invalid_argument);
    CHECK_THROWS_AS(line.choice("c", method, {"fast"}, ""), std::invalid_argument);
    CHECK_NOTHROW(line.number("d", none, app::positive, "", ""));
}

TEST_CASE("the nearest word") {
    // Fails if a swap of neighbours counts as two changes, or if anything at all is suggested.
    CHECK(app::nearest("kernles", {"lattice", "kernels"}) == "kernels");
    CHECK(app::nearest("ab", {"ba"}) == "ba");
    CHECK(app::nearest("tube", {"lattice", "slab"}).empty());
    CHECK(app::nearest("", {"a"}).empty());
    CHECK(app::nearest("a", {}).empty());
}

TEST_CASE("a number may be a fraction") {
    // Fails if what stands behind the slash is dropped, or if a division by 0 gets through.
    Program program;
    REQUIRE(program.parse({"--gamma", "5/3", "--x", "-1/4,1e1/2"}));
    CHECK(program.gamma == 5.0 / 3);
    CHECK(program.x == std::vector<double>{-0.25, 5});
    CHECK(usage_error({"--gamma", "5/0"}) == "--gamma: 5/0 is not a finite number; allowed: > 1 and <= 10");
    CHECK(usage_error({"--gamma", "5/3/1"}) == "--gamma: 5/3/1 is not a number; allowed: > 1 and <= 10");
    CHECK(usage_error({"--gamma", "5/"}) == "--gamma: 5/ is not a number; allowed: > 1 and <= 10");
}

TEST_CASE("a long option with one dash is no -h with something behind it") {
    // Fails if CLI11 gets the word: --help is printed, with status 0.
    CHECK(usage_error({"-help"}) == "unknown option -help; did you mean --help?");
    CHECK(usage_error({"-gamma", "2"}) == "unknown option -gamma; did you mean --gamma?");
    CHECK(usage_error({"-hgamma=2"}) == "unknown option -hgamma; did you mean --gamma?");
}

TEST_CASE("ranges and bounds are told in few letters") {
    // Fails for 1e+50, 1e-05, and a bound with all its digits.
    CHECK(app::Range{1e-50, 1e50}.text() == "1e-50..1e50");
    CHECK(app::Range{1e-5, 1e6}.text() == "1e-5..1e6");
    CHECK(app::Range{1e-10, 1e100}.text() == "1e-10..1e100");
    app::require_above("h", 0.7, 2.0 / 3, "");
    CHECK_THROWS_WITH(app::require_above("h", 2.0 / 3, 2.0 / 3, "here"),
                      "--h: 0.6666666666666666 is not allowed here; allowed: above 0.6667");
}

TEST_CASE("the values of a run: what it takes, given or by default") {
    // Fails if an option of others, one that is left out, or one without a value is told.
    Program program;
    double other = 1;
    program.line.foreign().number("other", other, app::any, "", "of others");
    REQUIRE(program.parse({"--gamma", "3/2"}));
    const auto values = program.line.values({"threads"});
    const auto told = [&](const std::string& name) {
        for (const auto& [known, value] : values) {
            if (known == name) return value;
        }
        return std::string{"not told"};
    };
    CHECK(told("gamma") == "1.5");
    CHECK(told("method") != "not told");
    CHECK(told("threads") == "not told");
    CHECK(told("other") == "not told");
    CHECK(told("quick") == "not told");
}
