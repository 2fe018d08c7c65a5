// What a run of a chapter leaves: figures, results, folders.
#include <catch2/catch.hpp>
#include <csignal>
#include <stdexcept>

#include "common/app/error.hpp"
#include "common/plot/webp_file.hpp"

#include "tests/common/report/book.hpp"

using namespace book;

TEST_CASE("a plain run makes all figures and their results, in order") {
    // Fails if a figure is left out, if results go elsewhere, or if the scene is not the figure's name.
    Book book;
    const auto outcome = book.run({});
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    CHECK(outcome.out.empty());
    CHECK_THAT(outcome.err, Catch::StartsWith("chapter 1: kernels done (1/2, "));
    CHECK(book.file("renders/01_test/results.csv") ==
          header + row("kernels", 100, "value", "1") + row("kernels", 1, "seed", "1") +
              row("errors", 100, "value", "2") + row("errors", 1, "seed", "1"));
    for (const auto* name : {"kernels.png", "kernels.csv", "errors.png", "errors.csv"})
        CHECK(book.has(std::string{"renders/01_test/"} + name));
    CHECK(book.file("chapters/01_test/README.md") == book.readme);
}

TEST_CASE("the options --quick and --out choose the folder") {
    // Fails if a quick run overwrites the book's figures.
    Book book;
    CHECK(book.run({"--quick"}).status == 0);
    CHECK_FALSE(book.has("renders"));
    CHECK_THAT(book.file("build/quick/01_test/results.csv"), Catch::Contains("kernels,sph,10,value"));
    CHECK(book.run({"--quick", "--out", (book.root() / "mine").string()}).status == 0);
    CHECK(book.has("mine/errors.png"));
    CHECK_FALSE(book.has("renders"));
}

TEST_CASE("the option --only makes one figure anew and keeps the others' results") {
    // Fails if results.csv is overwritten, or if a figure that is made anew moves to the end.
    Book book;
    REQUIRE(book.run({}).status == 0);
    const auto outcome = book.run({"--only", "kernels", "--seed", "7"});
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    CHECK(book.file("renders/01_test/results.csv") ==
          header + row("kernels", 100, "value", "1") + row("kernels", 1, "seed", "7") +
              row("errors", 100, "value", "2") + row("errors", 1, "seed", "1"));
    REQUIRE(book.run({"--only", "errors", "--width=2"}).status == 0);
    CHECK_THAT(book.file("renders/01_test/results.csv"),
               Catch::EndsWith(row("errors", 100, "value", "4") + row("errors", 1, "seed", "1")));
}

TEST_CASE("a full run drops results of figures that are no longer made, and a faulty file") {
    // Fails if older rows are merged into a full run.
    Book book;
    for (const std::string& older : {header + row("lost", 1, "q", "1"), std::string{"faulty\n"}}) {
        app::write_file(book.root() / "renders/01_test/results.csv", older);
        CHECK(book.run({}).status == 0);
        CHECK_THAT(book.file("renders/01_test/results.csv"),
                   !Catch::Contains("lost") && Catch::Contains("errors"));
    }
    app::write_file(book.root() / "renders/01_test/results.csv", "faulty\n");
    const auto outcome = book.run({"--only", "errors"});
    CHECK(outcome.status == 4);
    CHECK_THAT(outcome.err, Catch::EndsWith("results.csv: line 1: the header must be " + header));
    CHECK(book.file("renders/01_test/results.csv") == "faulty\n");
}

TEST_CASE("a figure's file tells how to make it again, and its bytes depend on nothing else") {
    // Fails if the folder or the number of threads gets into the metadata, or if a changed option does not.
    Book book;
    REQUIRE(book.run({"--threads", "1"}).status == 0);
    REQUIRE(book.run({"--threads", "2", "--out", (book.root() / "b").string()}).status == 0);
    CHECK(book.file("renders/01_test/errors.png") == book.file("b/errors.png"));
    CHECK_THAT(book.file("b/errors.png"), Catch::Contains("./tutorial run 01 --only errors") &&
                                              Catch::Contains("default") && Catch::Contains("abc123"));
    REQUIRE(book.run({"--quick", "--width", "2", "--seed", "5", "--only", "errors"}).status == 0);
    CHECK_THAT(book.file("build/quick/01_test/errors.png"),
               Catch::Contains("./tutorial run 01 --only errors --quick --seed 5 --width 2"));
    REQUIRE(book.run({"--scene", "tube", "--width", "2"}).status == 0);
    CHECK_THAT(book.file("build/scenes/01_test/tube/tube.png"),
               Catch::Contains("./tutorial run 01 --scene tube --width 2"));
}

TEST_CASE("an animation is saved like a figure") {
    // Fails if it goes elsewhere, has other metadata, or is drawn where only the text is checked.
    Book book;
    book.after_kernels = [](report::Run& run) {
        plot::Figure figure{"frame"};
        figure.panel().curve({0, 1}, {0, 1});
        run.save(plot::Animation{"film"}.add(figure).add(figure));
    };
    CHECK(book.run({"--check-text"}).status == 0);
    CHECK_FALSE(book.has("renders"));
    const auto outcome = book.run({"--only", "kernels"});
    if (plot::webp_version().empty()) {
        CHECK(outcome.status == 4);
        CHECK_THAT(outcome.err, Catch::Contains("libwebp-dev"));
        return;
    }
    CHECK(outcome.status == 0);
    CHECK_THAT(book.file("renders/01_test/film.csv"), Catch::StartsWith("frame,panel,"));
    CHECK_THAT(book.file("renders/01_test/film.webp"),
               Catch::Contains("./tutorial run 01 --only kernels") && Catch::Contains("abc123"));
}

TEST_CASE("a scene of the reader's own never touches the book's figures") {
    // Fails if a scene writes into renders/, or if its rows are not printed.
    Book book;
    const auto outcome = book.run({"--scene", "tube"});
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    CHECK_FALSE(book.has("renders"));
    const std::string rows = header + row("tube", 100, "value", "3") + row("tube", 1, "seed", "1");
    CHECK(outcome.out == "printed\n" + rows);
    // Its files tell their parameters.
    const std::string parameters = "# seed=1\n# width=1\n";
    CHECK(book.file("build/scenes/01_test/tube/results.csv") == parameters + rows);
    CHECK(book.file("build/scenes/01_test/tube/profile.csv") == parameters + "x,rho\n");
}

TEST_CASE("an unwritable folder is found before anything is computed") {
    // Fails if the folder is first needed when the first figure is saved.
    Book book;
    book.readme = "x";
    const auto outcome = book.run({"--out", (book.text() / "inner").string()});
    CHECK(outcome.status == 4);
    CHECK_THAT(outcome.err, Catch::StartsWith("error: cannot write into ") && !Catch::Contains("done"));
}

TEST_CASE("a failing figure leaves the finished ones") {
    // Fails if results are written only at the end, or if half a figure's rows are kept.
    Book book;
    app::write_file(book.root() / "renders/01_test/results.csv", header + row("errors", 100, "value", "9"));
    book.after_errors = [](report::Run&) { throw app::UnphysicalError{"p < 0 at t = 0.1"}; };
    const auto outcome = book.run({});
    CHECK(outcome.status == 3);
    CHECK_THAT(outcome.err, Catch::EndsWith("error: p < 0 at t = 0.1\n"));
    CHECK(book.has("renders/01_test/kernels.png"));
    CHECK(book.file("renders/01_test/results.csv") == header + row("kernels", 100, "value", "1") +
                                                          row("kernels", 1, "seed", "1") +
                                                          row("errors", 100, "value", "9"));
}

TEST_CASE("Ctrl-C ends a chapter with status 130 and keeps what is finished") {
    // Fails if long work does not notice Ctrl-C in results and timings.
    Book book;
    book.after_errors = [](report::Run& run) {
        std::raise(SIGINT);
        for (int k = 0; k < 100; ++k) run.time([] {});
    };
    const auto outcome = book.run({});
    CHECK(outcome.status == 130);
    CHECK_THAT(outcome.err, Catch::EndsWith("interrupted\n"));
    CHECK_THAT(book.file("renders/01_test/results.csv"),
               Catch::Contains("kernels") && !Catch::Contains("errors"));
}

TEST_CASE("a chapter's folder begins with its number") {
    // Fails if any name is accepted: the number is part of the command in each figure.
    CHECK_THROWS_AS((report::Chapter{"kernels", "", ""}), std::invalid_argument);
}
