#include "common/report/chapter.hpp"

#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <stdexcept>

#include "common/app/error.hpp"
#include "common/app/files.hpp"
#include "common/app/program.hpp"
#include "tests/common/app/child.hpp"

namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;
using Words = std::vector<std::string>;

/// A root folder with a chapter of two figures and one scene, whose program runs in a child process.
class Book {
  public:
    std::string readme =
        "kernels: <!-- fill kernels -->1.0<!-- end -->, errors: <!-- fill errors -->2.0<!-- end -->\n";
    std::function<void(report::Run&)> after_errors = [](report::Run&) {};

    child::Outcome run(Words words) {
        app::write_file(text(), readme);
        return child::run([&] {
            const child::Arguments arguments{words};
            report::Chapter chapter{"01_test", "Chapter 1. A test.", "abc123", root()};
            chapter.options().number("width", width_, app::positive, "dx", "smoothing length");
            chapter.figure("kernels", "the kernels", [this](report::Run& run) { make(run, "kernels", 1); });
            chapter.figure("errors", "their errors", [this](report::Run& run) {
                make(run, "errors", 2);
                after_errors(run);
            });
            chapter.scene("tube", "a tube of your own", [this](report::Run& run) {
                make(run, "tube", 3);
                run.write("profile.csv", "x,rho\n");
                run.print("printed\n");
            });
            return chapter.main(arguments.count(), arguments.values());
        });
    }
    fs::path root() const { return folder_.path(); }
    fs::path text() const { return root() / "chapters" / "01_test" / "README.md"; }
    std::string file(const std::string& path) const { return app::read_file(root() / path); }
    bool has(const std::string& path) const { return fs::exists(root() / path); }

  private:
    void make(report::Run& run, const std::string& name, double value) {
        plot::Figure figure{name};
        figure.panel().curve({0, 1}, {0, width_});
        figure.panel().labels("x", "y");
        run.result("sph", run.quick() ? 10 : 100, "value", value * width_);
        run.result("sph", 1, "seed", static_cast<double>(run.seed()));
        run.fill(name, report::number(value * width_, 2));
        run.save(figure);
    }
    child::Folder folder_;
    double width_ = 1;
};

std::string row(const std::string& scene, int n, const std::string& quantity, const std::string& value) {
    return scene + ",sph," + std::to_string(n) + "," + quantity + "," + value + ",1\n";
}
const std::string header = "scene,method,n,quantity,value,unit\n";

}  // namespace

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
    const auto outcome = book.run({"--only", "kernels", "--seed", "7", "--width=2"});
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    CHECK(book.file("renders/01_test/results.csv") ==
          header + row("kernels", 100, "value", "2") + row("kernels", 1, "seed", "7") +
              row("errors", 100, "value", "2") + row("errors", 1, "seed", "1"));
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
               Catch::Contains("./tutorial run 01 --only errors --width 2 --quick --seed 5"));
    REQUIRE(book.run({"--scene", "tube", "--width", "2"}).status == 0);
    CHECK_THAT(book.file("build/scenes/01_test/tube/tube.png"),
               Catch::Contains("./tutorial run 01 --scene tube --width 2"));
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
    CHECK(book.file("build/scenes/01_test/tube/results.csv") == rows);
    CHECK(book.file("build/scenes/01_test/tube/profile.csv") == "x,rho\n");
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
         {"Chapter 1. A test.", "--width X", "[dx]; > 0; default 1", "--quick", "--out DIR", "--only NAME",
          "--list", "--scene NAME", "--threads N", "1..256", "--seed N", "--version", "--update-text",
          "--check-text", "renders/01_test", "kernels  the kernels"})
        CHECK_THAT(help.out, Catch::Contains(text));
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
    check({"--update-text", "--width", "2"}, update + "--width 2: the text tells the defaults' numbers");
    check({"--check-text", "--scene", "tube"},
          "--check-text: needs a full run, not allowed together with --scene");
    check({"--check-text", "--update-text"}, "--update-text: not allowed together with --check-text");
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

TEST_CASE("the option --check-text compares without writing anything") {
    // Fails if a changed digit passes, if anything is drawn, or if work is timed more than once.
    Book book;
    book.after_errors = [](report::Run& run) {
        int calls = 0;
        if (run.time([&] { ++calls; }).calls != 1 || calls != 1)
            throw std::runtime_error{"timed more than once"};
        run.write("x.csv", "x");
        run.print("x");
    };
    const auto same = book.run({"--check-text"});
    INFO(same.err);
    CHECK(same.status == 0);
    CHECK(same.out.empty());
    CHECK_FALSE(book.has("renders"));
    book.readme =
        "kernels: <!-- fill kernels -->1.1<!-- end -->, errors: <!-- fill errors -->2.3<!-- end -->\n";
    const auto changed = book.run({"--check-text"});
    CHECK(changed.status == 1);
    CHECK_THAT(changed.err, Catch::Contains("errors: 2.3 is printed, 2.0 computed\nerror: ") &&
                                Catch::EndsWith("README.md: 1 difference\n"));
    CHECK(book.file("chapters/01_test/README.md") == book.readme);
}

TEST_CASE("the option --update-text rewrites the text after a full run") {
    // Fails if the text is written before the run has ended well, or not at all.
    Book book;
    book.readme = "kernels: <!-- fill kernels -->?<!-- end -->, errors: <!-- fill errors -->?<!-- end -->\n";
    REQUIRE(book.run({"--update-text"}).status == 0);
    CHECK(book.file("chapters/01_test/README.md") ==
          "kernels: <!-- fill kernels -->1.0<!-- end -->, errors: <!-- fill errors -->2.0<!-- end -->\n");
    book.readme = "<!-- fill kernels -->?<!-- end -->\n";
    const auto lacking = book.run({"--update-text"});
    CHECK(lacking.status == 1);
    CHECK_THAT(lacking.err, Catch::EndsWith("README.md: the text has no <!-- fill errors -->\n"));
    CHECK(book.file("chapters/01_test/README.md") == book.readme);
}

TEST_CASE("a block is filled with one text only") {
    // Fails if the second text silently replaces the first.
    Book book;
    book.after_errors = [](report::Run& run) { run.fill("errors", "2.0"); };
    CHECK(book.run({}).status == 0);
    book.after_errors = [](report::Run& run) { run.fill("errors", "2.1"); };
    CHECK(book.run({}).status == 1);
}

TEST_CASE("a chapter's folder begins with its number") {
    // Fails if any name is accepted: the number is part of the command in each figure.
    CHECK_THROWS_AS((report::Chapter{"kernels", "", ""}), std::invalid_argument);
}
