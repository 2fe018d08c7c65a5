// Exercises: their form, and that their commands are found and run.
#include "tests/lesson/rules/exercises.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/lesson/rules/shell.hpp"
#include "tests/lesson/sample.hpp"

using sample::after, sample::breaks, sample::keeps, sample::with;
namespace fs = std::filesystem;

// Fails if two or four exercises pass, or their numbers.
TEST_CASE("there are three exercises with their numbers") {
    breaks(with("## Try next", "## Try"), "no section \"## Try next\"");
    breaks(with("### 2. A wider", "### 4. A wider"), "### 2. ...");
    const auto exercise = sample::text.find("### 3."), appendix = sample::text.find("## Appendix");
    const std::string third = sample::text.substr(exercise, appendix - exercise);
    breaks(with(third, ""), "three exercises, not 2");
    breaks(after(third, "### 4." + third.substr(6)), "three exercises, not 4");
}
TEST_CASE("an exercise has a command, what one should see, and a folded solution") {
    breaks(with("./tutorial exact riemann --points 101\n", "make\n"),
           "no block of code with a ./tutorial command");
    breaks(with("./tutorial exact riemann", "time ./tutorial exact riemann",
                after("--points 101\n", "./tutorial run 04\n")),
           "begins with ./tutorial");
    breaks(with("You should\nsee a wider", "There is a wider"), "\"2. A wider kernel\" does not say");
    breaks(with("<summary>Why</summary>Three", "Three"), "\"3. The exact tube\" has no folded solution");
    for (const char* half : {"<summary>Why", "Why</summary>"})
        breaks(with("<summary>Why</summary>Three", half), "no folded solution");
    breaks(with("<details>\n", ""), "no folded solution");
    breaks(with("waves.</details>", "waves."), "no folded solution");
    keeps(after("--points 101\n", "make me\n"));
}

TEST_CASE("commands are read from the exercises only, with their lines and the status that they exit with") {
    const auto commands = lesson::commands_of(
        "```\n./tutorial run 01\n```\n## Try next\n./tutorial run 02\n```\n./tutorial run 03 --left '1 #2' # "
        "why\nmake\n"
        "  ./tutorial exact x \\\n  --points 3   # exits with status 3\n```\n## Appendix\n```\n./tutorial "
        "run 04\n```\n");
    REQUIRE(commands.size() == 2);
    CHECK((commands[0].line == 7 && commands[0].text == "./tutorial run 03 --left '1 #2'" &&
           commands[0].status == 0));
    CHECK((commands[1].line == 9 && commands[1].text == "./tutorial exact x --points 3" &&
           commands[1].status == 3));
}

namespace {

/// Programs that write their arguments down and exit with the status that --status names.
struct Programs {
    lesson::TemporaryFolder folder;
    fs::path written = folder.path / "written";
    Programs() {
        for (const char* name :
             {"04_artificial_viscosity_tests", "04_artificial_viscosity", "05_none_tests", "exact"}) {
            const fs::path file = folder.path / name;
            std::ofstream{file} << "#!/bin/sh\necho " << name << " \"$@\" >>'" << written.string()
                                << "'\necho said\nexit ${STATUS:-0}\n";
            fs::permissions(file, fs::perms::owner_all);
        }
    }
    std::string invocation(const std::string& command) const {
        return lesson::invocation(command, folder.path, "/o").value_or("nothing");
    }
    std::string program(const std::string& name) const { return "'" + (folder.path / name).string() + "'"; }
};

}  // namespace

// Fails if --out is not replaced in both of its forms, or not added, or added to `exact`.
TEST_CASE("a command becomes a call of the chapter's program, which writes into a folder of the test") {
    const Programs programs;
    const std::string four = programs.program("04_artificial_viscosity"), exact = programs.program("exact");
    CHECK(programs.invocation("./tutorial run 04") == four + " --out '/o'");
    CHECK(programs.invocation("./tutorial run 4 --left '1,0'") == four + " --out '/o' --left '1,0'");
    CHECK(programs.invocation("./tutorial run 04 --out /tmp/a --quick") == four + " --out '/o' --quick");
    CHECK(programs.invocation("./tutorial run 04 --quick --out=\"/tmp/a b\"") ==
          four + " --quick --out '/o'");
    CHECK(programs.invocation("./tutorial exact riemann --points 3") == exact + " riemann --points 3");
    for (const char* skipped : {"test 04", "figures 04 --quick", "bench", "doctor"})
        CHECK(programs.invocation(std::string{"./tutorial "} + skipped) == "nothing");
    CHECK_THROWS_WITH(programs.invocation("./tutorial rum 04"), Catch::Contains("no command 'rum'"));
    CHECK_THROWS_WITH(programs.invocation("./tutorial run 05"), Catch::Contains("no program of chapter 05"));
}

// Fails if the exit status is not compared, or not the one that the text states.
TEST_CASE("exercises are run, and those that end otherwise than the text says are named") {
    const Programs programs;
    const auto run = [&](const std::string& lines) {
        return lesson::failures("## Try next\n```\n" + lines + "\n```\n", programs.folder.path);
    };
    CHECK(run("./tutorial run 04 --scene tube\n./tutorial exact riemann >riemann.csv\n./tutorial test 04")
              .empty());
    const std::string written = lesson::read_file(programs.written);
    CHECK_THAT(written, Catch::Contains("04_artificial_viscosity --out /") &&
                            Catch::Contains("--scene tube\n") && Catch::Contains("exact riemann\n") &&
                            !Catch::Contains("_tests"));
    const auto status = run("./tutorial run 04 # exits with status 3\n./tutorial rum");
    REQUIRE(status.size() == 2);
    CHECK_THAT(status[0], Catch::Contains("README.md:3: ./tutorial run 04: exit status 0, not 3\nsaid\n"));
    CHECK_THAT(status[1], Catch::Contains("README.md:4: ./tutorial rum: ./tutorial knows no command 'rum'"));
    setenv("STATUS", "3", 1);
    CHECK(run("./tutorial run 04 # exits with status 3").empty());
    CHECK(run("./tutorial exact riemann").size() == 1);
    unsetenv("STATUS");
}

TEST_CASE("a command that a signal ends did not exit with status 0") {
    CHECK(lesson::run_in("/", "kill -9 $$").status == 137);
    CHECK(lesson::run_in("/usr", "pwd").text == "/usr\n");
}
