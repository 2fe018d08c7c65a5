// The numbers in a chapter's text.
#include <catch2/catch.hpp>
#include <stdexcept>

#include "tests/common/report/book.hpp"

using namespace book;

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

TEST_CASE("a part of the figures does not rewrite the text") {
    // Fails if a text is written half.
    Book book;
    CHECK(book.run({"--timed", "only", "--update-text"}).status == 2);
    CHECK(book.file("chapters/01_test/README.md") == book.readme);
}

TEST_CASE("a full run puts its seconds into the book's table") {
    // Fails if another chapter's seconds are replaced.
    Book book;
    const std::string table =
        "| <!-- fill seconds-01_test -->?<!-- end --> | <!-- fill seconds-02_other -->9 s<!-- end --> |\n";
    app::write_file(book.root() / "README.md", table);
    REQUIRE(book.run({"--update-text"}).status == 0);
    CHECK_THAT(book.file("README.md"),
               Catch::Matches("\\| <!-- fill seconds-01_test -->≈[0-9.e-]+ s<!-- end --> \\| <!-- fill "
                              "seconds-02_other -->9 s<!-- end --> \\|\n"));
}

TEST_CASE("a block is filled with one text only") {
    // Fails if the second text silently replaces the first.
    Book book;
    book.after_errors = [](report::Run& run) { run.fill("errors", "2.0"); };
    CHECK(book.run({}).status == 0);
    book.after_errors = [](report::Run& run) { run.fill("errors", "2.1"); };
    CHECK(book.run({}).status == 1);
}
