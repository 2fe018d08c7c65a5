// The chapters' texts against the rules of a lesson, and every formula of the texts.
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/lesson/rules/formulas.hpp"
#include "tests/lesson/rules/lesson.hpp"
#include "tests/lesson/rules/pandoc.hpp"
#include "tests/lesson/rules/shell.hpp"
#include "tests/structure/tracked.hpp"

namespace {

namespace fs = std::filesystem;
const fs::path root{SPH_SOURCE_DIR};

/// The chapters' texts by the names of their folders.
std::map<std::string, std::string> chapters() {
    std::map<std::string, std::string> found;
    for (const auto& entry : fs::directory_iterator{root / "chapters"}) {
        if (structure::is_ours(entry.path(), true))
            found[entry.path().filename().string()] = lesson::read_file(entry.path() / "README.md");
    }
    return found;
}

std::vector<fs::path> texts() {
    std::vector<fs::path> found{"README.md", "CONTRIBUTING.md"};
    for (const char* folder : {"chapters", "common", "tests"}) {
        for (const auto& entry : fs::recursive_directory_iterator{root / folder}) {
            if (entry.path().filename() == "README.md" && structure::is_ours(entry.path(), true))
                found.push_back(fs::relative(entry.path(), root));
        }
    }
    return found;
}

}  // namespace

TEST_CASE("a chapter's text keeps the rules of a lesson") {
    CHECK(chapters().size() > 4);
    for (const auto& [folder, text] : chapters()) {
        for (const std::string& breach : lesson::breaches(text, folder)) {
            INFO(folder);
            FAIL_CHECK(breach);
        }
    }
}

TEST_CASE("a lesson's references to equations of other lessons find them") {
    std::map<std::string, std::set<int>> tags;  // of the lessons
    for (const auto& [folder, text] : chapters()) {
        const lesson::Lesson chapter{text, folder};
        for (const auto& tag : lesson::tags_of(chapter.blocks)) tags[chapter.chapter].insert(tag.number);
    }
    for (const auto& [folder, text] : chapters()) {
        for (const auto& reference : lesson::references_of(lesson::blocks_of(text))) {
            INFO(folder << "/README.md:" << reference.line);
            INFO("(" << reference.chapter << "." << reference.number << ")");
            CHECK(
                (tags.count(reference.chapter) == 0 || tags[reference.chapter].count(reference.number) > 0));
        }
    }
}

TEST_CASE("pandoc reads every formula of the texts") {
    if (!lesson::has_pandoc()) FAIL("pandoc is missing. On Debian: apt-get install pandoc");
    std::vector<std::string> formulas, where;
    for (const fs::path& path : texts()) {
        const std::string text = lesson::read_file(root / path);
        CHECK(!lesson::contains(text, "$$"));
        for (const auto& formula : lesson::formulas_of(text)) {
            formulas.push_back(formula.tex);
            where.push_back(path.string() + ":" + std::to_string(formula.line));
        }
    }
    CHECK(formulas.size() > 3);  // they were found
    if (lesson::reads(formulas)) return;
    for (std::size_t k = 0; k < formulas.size(); ++k) {
        if (!lesson::reads({formulas[k]}))
            FAIL_CHECK(where[k] + ": $`" + formulas[k] + "`$\n" + lesson::complaint_of(formulas[k]));
    }
}

TEST_CASE("pandoc reads formulas, and names what it cannot read") {
    if (!lesson::has_pandoc()) FAIL("pandoc is missing. On Debian: apt-get install pandoc");
    CHECK(lesson::reads({"a_i^* = \\sum_j \\frac{m_j}{\\rho_j} \\tag{4.1}", "x_{ij}"}));
    CHECK_FALSE(lesson::reads({"x_{ij}", "\\frac{a}{"}));
    CHECK_FALSE(lesson::reads({"\\unheardof x"}));
    CHECK_FALSE(lesson::reads({""}));
    CHECK_THAT(lesson::complaint_of("\\unheardof x"), Catch::Contains("unheardof"));
}
