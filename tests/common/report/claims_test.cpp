// Sentences of a text, and what the run that measures them says.
#include "common/report/claims.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "tests/common/report/book.hpp"

using namespace book;
using report::Verdict;

namespace {

const std::string with_claim =
    "kernels: <!-- fill kernels -->1.0<!-- end -->, <!-- claim falls -->its errors "
    "(<!-- fill errors -->2.0<!-- end --> here) fall<!-- end -->.\n";

std::function<void(report::Run&)> asserting(bool holds, report::Needs needs = report::Needs::full_run) {
    return [=](report::Run& run) {
        run.claim(
            "falls", [=] { return holds; }, needs);
    };
}

}  // namespace

TEST_CASE("claims are found with the numbers inside them") {
    // Fails if the end of a filled number ends the claim, so that a nested claim is not seen.
    CHECK(report::claims_of(with_claim) == Words{"falls"});
    CHECK(report::claims_of("<!-- claim a -->x<!-- end --> <!-- claim b -->y<!-- end --> "
                            "<!-- claim a -->z<!-- end -->") == Words{"a", "b"});
    CHECK(report::claims_of("<!-- code f.hpp part -->\n").empty());
    CHECK_THROWS_AS(report::claims_of("<!-- claim a -->x"), std::invalid_argument);
    CHECK_THROWS_AS(report::claims_of("<!-- claim -->x<!-- end -->"), std::invalid_argument);
    CHECK_THROWS_AS(report::claims_of("<!-- claim a -->x <!-- claim b -->y<!-- end --><!-- end -->"),
                    std::invalid_argument);
    CHECK_THROWS_AS(report::claims_of("<!-- claim a -->x <!-- fill n -->1<!-- end -->"),
                    std::invalid_argument);
}

TEST_CASE("a claim has a sentence, an assertion, and holds") {
    // Fails if one of the three is not asked for.
    const std::string text = "<!-- claim a -->x<!-- end -->";
    CHECK(report::broken_claims(text, "", "04", {{"a", Verdict::holds}}).empty());
    CHECK(report::broken_claims(text, "", "04", {}) ==
          Words{"claim a: stands in the text, but nothing asserts it"});
    CHECK(report::broken_claims("", "", "04", {{"a", Verdict::holds}}) ==
          Words{"claim a: is asserted, but does not stand in the text"});
    CHECK(report::broken_claims(text, "", "04", {{"a", Verdict::fails}}) == Words{"claim a: does not hold"});
}

TEST_CASE("the book's text tells claims of several chapters") {
    // Fails if another chapter's claims count, or the own ones do not.
    const std::string book = "<!-- claim 03:b -->x<!-- end --> <!-- claim 04:a -->y<!-- end -->";
    CHECK(report::broken_claims("", book, "04", {{"a", Verdict::holds}}).empty());
    CHECK(report::broken_claims("", book, "04", {}).size() == 1);
    CHECK(report::broken_claims("", book, "08", {}).empty());
}

TEST_CASE("the text test judges claims") {
    // Fails if a sentence that does not hold passes, or is not named.
    Book book;
    book.readme = with_claim;
    book.after_errors = asserting(true);
    const auto good = book.run({"--check-text"});
    INFO(good.err);
    CHECK(good.status == 0);
    book.after_errors = asserting(false);
    const auto wrong = book.run({"--check-text"});
    CHECK(wrong.status == 1);
    CHECK_THAT(wrong.err, Catch::Contains("claim falls: does not hold\n"));
    CHECK(book.run({"--update-text"}).status == 1);
    book.after_errors = [](report::Run&) {};
    CHECK_THAT(book.run({"--check-text"}).err, Catch::Contains("nothing asserts it"));
    book.after_errors = [](report::Run& run) {
        asserting(true)(run);
        asserting(true)(run);
    };
    CHECK(book.run({"--check-text"}).status == 1);
}

TEST_CASE("a run that does not look at the text says what it finds of its claims") {
    // Fails if a quick run judges what it has not measured, keeps silent about it, or takes a reader's own
    // parameters for an error.
    Book book;
    book.readme = with_claim;
    book.after_errors = asserting(false);
    const auto quick = book.run({"--quick"});
    CHECK(quick.status == 0);
    CHECK_THAT(quick.err, Catch::Contains("claims that need a full run: falls\n"));
    const auto full = book.run({});
    CHECK(full.status == 0);  // a busy machine breaks claims about times
    CHECK_THAT(full.err, Catch::Contains("warning: claims of the text that do not hold in this run"));
    CHECK(book.has("renders/01_test/errors.png"));  // what was made is there
    const auto own = book.run({"--only", "errors", "--width", "2"});
    CHECK(own.status == 0);
    CHECK_THAT(own.err,
               Catch::Contains("warning: claims of the text that do not hold with --width 2: falls"));
    book.after_errors = asserting(false, report::Needs::any_run);
    CHECK_THAT(book.run({"--quick"}).err, Catch::Contains("that do not hold in this run"));
}
