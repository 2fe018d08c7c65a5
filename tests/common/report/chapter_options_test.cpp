// What a chapter's program is asked, and what it refuses.
#include <catch2/catch.hpp>

#include "tests/common/report/book.hpp"

using namespace book;

TEST_CASE("an option that the chosen figure or scene does not take is refused, naming those that do") {
    // Fails if it is ignored: the picture would bear an option that it does not show.
    Book book;
    const auto check = [&](Words words, const std::string& message) {
        const auto outcome = book.run(std::move(words));
        CHECK(outcome.status == 2);
        CHECK(outcome.err == "error: " + message + "\n");
        CHECK_FALSE(book.has("renders"));
        CHECK_FALSE(book.has("build"));
    };
    check({"--width", "2"},
          "--width: a run of all figures does not take it; allowed with --only errors, --scene tube");
    check({"--only", "kernels", "--width", "2"},
          "--width: the figure kernels does not take it; allowed with --only errors, --scene tube");
    check({"--only=errors", "--long"},
          "--long: the figure errors does not take it; allowed with --scene tube");
    check({"--quick", "--width=1"},
          "--width: a run of all figures does not take it; allowed with --only errors, --scene tube");
    check({"--width", "0"}, "--width: 0 is not allowed; allowed: > 0");
    check({"--widht", "2"}, "unknown option --widht; did you mean --width?");
    CHECK(book.run({"--scene", "tube", "--long", "--width", "2"}).status == 0);
}

TEST_CASE("each figure and scene has its own values of an option") {
    // Fails if an option of one name is one variable for all: declared for the figure, it would act on
    // others.
    Book book;
    REQUIRE(book.run({"--scene", "tube", "--width", "2"}).status == 0);
    CHECK_THAT(book.file("build/scenes/01_test/tube/results.csv"),
               Catch::Contains(row("tube", 100, "value", "6")));
    REQUIRE(book.run({"--only", "errors", "--width", "3"}).status == 0);
    CHECK_THAT(book.file("renders/01_test/results.csv"), Catch::Contains(row("errors", 100, "value", "6")));
    REQUIRE(book.run({}).status == 0);
    CHECK_THAT(book.file("renders/01_test/results.csv"), Catch::Contains(row("errors", 100, "value", "2")));
}

TEST_CASE("only a timed figure or a scene may show times") {
    // Each fails if its check is left out: times of figures that are made beside others are wrong.
    const std::vector<std::function<void(report::Run&)>> times{
        [](report::Run& run) { run.time([] {}); },
        [](report::Run& run) { run.result("sph", 1, "cpu", 1, "s"); },
        [](report::Run& run) {
            run.record("sph", 1, {{"cpu", 1, "ns"}});
        },
        [](report::Run& run) { run.fill("cost", "takes ≈2 s"); }};
    for (const auto& show : times) {
        Book book;
        book.after_kernels = show;
        const auto untimed = book.run({"--only", "kernels"});
        CHECK(untimed.status == 1);
        CHECK_THAT(untimed.err, Catch::StartsWith("error: kernels: ") &&
                                    Catch::Contains("is a time, so this must be a timed_figure"));
        Book timed;
        timed.after_errors = show;
        CHECK(timed.run({"--only", "errors"}).status == 0);
    }
}

TEST_CASE("a figure that shows times has one thread") {
    // Fails if it has two: the seconds of one of them would be half of the truth.
    Book book;
    book.after_kernels =
        book.after_errors = [](report::Run& run) { run.result("sph", 1, "threads", run.threads()); };
    REQUIRE(book.run({"--threads", "2"}).status == 0);
    const std::string results = book.file("renders/01_test/results.csv");
    CHECK_THAT(results, Catch::Contains(row("kernels", 1, "threads", "2")));
    CHECK_THAT(results, Catch::Contains(row("errors", 1, "threads", "1")));
}

TEST_CASE("figures that show times are made apart from the others") {
    // Fails if --timed chooses the wrong ones, or drops the rows of those that were made before.
    Book book;
    REQUIRE(book.run({"--timed", "none"}).status == 0);
    CHECK(book.has("renders/01_test/kernels.png"));
    CHECK_FALSE(book.has("renders/01_test/errors.png"));
    const auto outcome = book.run({"--timed", "only"});
    CHECK_THAT(outcome.err, Catch::StartsWith("chapter 1: errors done (1/1, "));
    CHECK(book.file("renders/01_test/results.csv") ==
          header + row("kernels", 100, "value", "1") + row("kernels", 1, "seed", "1") +
              row("errors", 100, "value", "2") + row("errors", 1, "seed", "1"));
    for (const Words& words :
         {Words{"--timed", "only", "--only", "errors"}, {"--timed", "none", "--scene", "tube"}})
        CHECK(book.run(words).err == "error: --timed: not allowed together with --only or --scene\n");
    CHECK(book.run({"--timed", "none", "--check-text"}).err ==
          "error: --check-text: needs a full run, not allowed together with --timed\n");
    CHECK(book.run({"--timed", "some"}).status == 2);
}

TEST_CASE("the options --list and --help name figures and scenes and compute nothing") {
    // Fails if either starts the work or creates a folder.
    Book book;
    const auto list = book.run({"--list"});
    CHECK(list.status == 0);
    CHECK(list.out ==
          "figures:\n  kernels  the kernels\n  errors   their errors\nscenes:\n  tube  a tube of your own\n");
    const auto help = book.run({"--help"});
    CHECK(help.status == 0);
    for (const auto* text :
         {"Chapter 1. A test.", "--quick", "--out DIR", "--only NAME", "--list", "--scene NAME",
          "--threads N", "1..256", "--seed N", "--timed NAME", "--version", "--update-text", "--check-text",
          "renders/01_test", "kernels  the kernels", "\nOptions of --only errors:\n  --width X",
          "[dx]; > 0; default 1", "\nOptions of --scene tube:\n  --width X", "--long"})
        CHECK_THAT(help.out, Catch::Contains(text));
    // Once for each that takes it, and not among the options of all.
    std::size_t count = 0;
    for (std::size_t at = 0; (at = help.out.find("--width", at)) != std::string::npos; ++at) ++count;
    CHECK(count == 2);
    CHECK_FALSE(book.has("renders"));
}

TEST_CASE("bad usage of a chapter") {
    // Each line fails if its check is left out.
    Book book;
    const auto check = [&](Words words, const std::string& message) {
        const auto outcome = book.run(std::move(words));
        CHECK(outcome.status == 2);
        CHECK(outcome.err == "error: " + message + "\n");
        CHECK_FALSE(book.has("renders"));
    };
    const std::string update = "--update-text: needs a full run, not allowed together with ";
    check({"--only", "kernles"},
          "--only: kernles is not known, did you mean kernels?; allowed: kernels, errors");
    check({"--scene", "tub"}, "--scene: tub is not known, did you mean tube?; allowed: tube");
    check({"--threads", "0"}, "--threads: 0 is not allowed; allowed: 1..256");
    check({"--seed", "-1"}, "--seed: -1 is not allowed; allowed: >= 0");
    check({"--only", "errors", "--scene", "tube"}, "--only: not allowed together with --scene");
    check({"--update-text", "--quick"}, update + "--quick");
    check({"--update-text", "--only", "errors"}, update + "--only");
    check({"--update-text", "--seed", "2"}, update + "--seed 2: the text tells the defaults' numbers");
    check({"--only", "errors", "--scene", "tube", "--width", "2"},
          "--only: not allowed together with --scene");  // both take it
    check({"--check-text", "--scene", "tube"},
          "--check-text: needs a full run, not allowed together with --scene");
    check({"--check-text", "--update-text"}, "--update-text: not allowed together with --check-text");
}
