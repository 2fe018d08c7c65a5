// The rules of the architecture, read from the sources: dependencies point one way.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/structure/tracked.hpp"

namespace {

namespace fs = std::filesystem;

struct Include {
    std::string file, target;  // file: path from the root; target: what stands between the quotes or brackets
};

/// The chapter number of a path like chapters/04_name/..., 0 if it lies in no chapter.
int chapter_of(const std::string& path) {
    std::smatch match;
    return std::regex_search(path, match, std::regex{"^chapters/([0-9]{2})_"}) ? std::stoi(match[1]) : 0;
}
bool starts_with(const std::string& text, const std::string& prefix) {
    return text.rfind(prefix, 0) == 0;
}

std::string first_of(const std::vector<std::string>& found) {
    return found.empty() ? "" : found.front();
}

std::vector<Include> includes_below(const fs::path& root, const std::vector<std::string>& folders) {
    std::vector<Include> includes;
    const std::regex pattern{"^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]"};
    for (const std::string& folder : folders) {
        for (const auto& entry : fs::recursive_directory_iterator{root / folder}) {
            const std::string extension = entry.path().extension().string();
            if (extension != ".hpp" && extension != ".cpp") continue;
            std::ifstream stream{entry.path()};
            for (std::string line; std::getline(stream, line);) {
                std::smatch match;
                if (std::regex_search(line, match, pattern)) {
                    includes.push_back({fs::relative(entry.path(), root).generic_string(), match[1]});
                }
            }
        }
    }
    return includes;
}

/// Breaches of the rules among `includes`, one line each.
std::vector<std::string> breaches(const std::vector<Include>& includes) {
    std::vector<std::string> found;
    for (const Include& include : includes) {
        const std::string &file = include.file, &target = include.target;
        const auto breach = [&](const std::string& rule) {
            found.push_back(file + " includes " + target + ": " + rule);
        };
        const int from = chapter_of(file), to = chapter_of(target);
        if (from > 0 && to > from) breach("a later chapter");
        if (starts_with(file, "common/") && to > 0) breach("common/ uses no chapter");
        if (starts_with(target, "tests/") && !starts_with(file, "tests/")) breach("only tests use tests");
        const bool renderer =
            std::regex_search(target, std::regex{"^(GL/|EGL/|webp/|png\\.h|ft2build\\.h|freetype/|FT_)"});
        const bool draws = starts_with(file, "common/plot/") || starts_with(file, "tests/common/plot/");
        if (renderer && !draws) breach("only common/plot knows the renderer");
        const bool exact = starts_with(file, "common/exact/");
        if (exact && (starts_with(target, "common/core/") || to > 0)) breach("common/exact knows no SPH");
        const bool app = starts_with(file, "common/app/");
        if (app && starts_with(target, "common/") && !starts_with(target, "common/app/"))
            breach("app is the lowest layer");
        const bool core = starts_with(file, "common/core/");
        if (core && starts_with(target, "common/") && !starts_with(target, "common/core/") &&
            !starts_with(target, "common/app/")) {
            breach("core uses only app");
        }
        const bool report = starts_with(file, "common/report/");
        if (report && (starts_with(target, "common/core/") || starts_with(target, "common/exact/")))
            breach("report knows neither particles nor solutions");
        const bool plot = starts_with(file, "common/plot/");
        if (plot && (starts_with(target, "common/report/") || starts_with(target, "common/core/") ||
                     starts_with(target, "common/exact/"))) {
            breach("plot uses only app");
        }
    }
    return found;
}

const fs::path root{SPH_SOURCE_DIR};

}  // namespace

TEST_CASE("dependencies point one way") {
    const auto includes = includes_below(root, {"common", "chapters", "tests"});
    REQUIRE(includes.size() > 50);  // the sources were found
    const auto found = breaches(includes);
    INFO(first_of(found));
    CHECK(found.empty());
}

TEST_CASE("the check of dependencies sees each kind of breach") {
    CHECK(breaches({{"chapters/01_a/x.hpp", "chapters/02_b/y.hpp"}}).size() == 1);
    CHECK(breaches({{"common/core/x.hpp", "chapters/01_a/y.hpp"}}).size() == 1);
    CHECK(breaches({{"chapters/01_a/x.cpp", "GL/osmesa.h"}}).size() == 1);
    CHECK(breaches({{"common/report/x.cpp", "png.h"}}).size() == 1);
    CHECK(breaches({{"common/report/x.cpp", "webp/mux.h"}}).size() == 1);
    CHECK(breaches({{"common/exact/x.cpp", "common/core/cells.hpp"}}).size() == 1);
    CHECK(breaches({{"common/app/x.cpp", "common/plot/figure.hpp"}}).size() == 1);
    CHECK(breaches({{"common/plot/x.cpp", "common/report/text.hpp"}}).size() == 1);
    CHECK(breaches({{"common/core/x.hpp", "common/report/timer.hpp"}}).size() == 1);
    CHECK(breaches({{"common/report/x.cpp", "common/core/cells.hpp"}}).size() == 1);
    CHECK(breaches({{"common/core/x.hpp", "common/app/team.hpp"}}).empty());
    CHECK(breaches({{"chapters/02_b/x.hpp", "chapters/01_a/y.hpp"}, {"common/plot/x.cpp", "png.h"}}).empty());
    CHECK(breaches({{"tests/common/plot/x.cpp", "webp/demux.h"}}).empty());  // reads back what plot writes
}

TEST_CASE("the top level holds what the README says and nothing else") {
    const std::vector<std::string> allowed{"CMakeLists.txt",
                                           "CMakePresets.json",
                                           "CONTRIBUTING.md",
                                           "CHANGELOG.md",
                                           "CITATION.cff",
                                           "LICENSE",
                                           "README.md",
                                           "tutorial",
                                           "chapters",
                                           "common",
                                           "renders",
                                           "tests",
                                           ".ci",
                                           ".clang-format",
                                           ".clang-tidy",
                                           ".git",
                                           ".gitignore",
                                           "build"};
    for (const auto& entry : fs::directory_iterator{root}) {
        if (!structure::is_ours(entry.path(), false)) continue;
        INFO(entry.path().filename());
        CHECK(std::find(allowed.begin(), allowed.end(), entry.path().filename()) != allowed.end());
    }
    for (const std::string& name : allowed) {
        if (name != ".git" && name != "build") {
            INFO(name);
            CHECK(fs::exists(root / name));
        }
    }
}

TEST_CASE("every chapter has its text, its program and its renders") {
    for (const auto& entry : fs::directory_iterator{root / "chapters"}) {
        if (!structure::is_ours(entry.path(), true)) continue;
        const std::string name = entry.path().filename().string();
        INFO(name);
        CHECK(std::regex_match(name, std::regex{"[0-9]{2}_[a-z_]+"}));
        CHECK(fs::exists(entry.path() / "README.md"));
        CHECK(fs::exists(entry.path() / "main.cpp"));
        CHECK(fs::exists(root / "renders" / name / "results.csv"));
        CHECK(fs::exists(root / "tests" / name));
    }
}

namespace {

/// The targets of a text's links and pictures inside the repository. What stands in a block of code is no
/// link: the lambda "[](double) {" is not.
std::vector<std::string> links_of(std::istream& text) {
    const std::regex link{"\\]\\(([^)#: ]+)(#[^)]*)?\\)|<img src=\"([^\":]+)\""};
    std::vector<std::string> found;
    bool code = false;
    for (std::string line; std::getline(text, line);) {
        if (starts_with(line, "```")) code = !code;
        if (code) continue;
        for (std::sregex_iterator match{line.begin(), line.end(), link}, end; match != end; ++match)
            found.push_back((*match)[1].matched ? (*match)[1] : (*match)[3]);
    }
    return found;
}

}  // namespace

TEST_CASE("links and pictures in the texts exist") {
    int links = 0;
    const auto passing_by = fs::directory_options::skip_permission_denied;
    for (const auto& entry : fs::recursive_directory_iterator{root, passing_by}) {
        const std::string path = fs::relative(entry.path(), root).generic_string();
        if (entry.path().extension() != ".md" || starts_with(path, "build/") || starts_with(path, ".git/"))
            continue;
        if (!structure::is_ours(entry.path(), true)) continue;
        std::ifstream stream{entry.path()};
        for (const std::string& target : links_of(stream)) {
            INFO(path << " links to " << target);
            CHECK(fs::exists(entry.path().parent_path() / target));
            ++links;
        }
    }
    CHECK(links > 20);
}

TEST_CASE("the check of links reads links, and no code") {
    std::istringstream text{
        "see [a](x.md#part) and ![b](y.png)\n```cpp\n[](double) { f(); }\n```\n[c](z)\n<img "
        "src=\"w.png\">\n"};
    CHECK(links_of(text) == std::vector<std::string>{"x.md", "y.png", "z", "w.png"});
}

namespace {

std::string read(const fs::path& path) {
    std::ifstream stream{path};
    return {std::istreambuf_iterator<char>{stream}, {}};
}

/// Lines without the indentation that all of them have.
std::string unindented(const std::string& text) {
    std::istringstream lines{text};
    std::vector<std::string> all;
    std::size_t least = std::string::npos;
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty()) least = std::min(least, line.find_first_not_of(' '));
        all.push_back(line);
    }
    std::string result;
    for (const std::string& line : all) result += (line.empty() ? "" : line.substr(least)) + "\n";
    return result;
}

/// What stands between a line "// [name]" and the next "// [end]" of a source, unindented.
std::string part_of(const std::string& source, const std::string& name) {
    const std::string begin = "// [" + name + "]\n";
    const auto first = source.find(begin);
    const auto last = source.find("// [end]", first);
    if (first == std::string::npos || last == std::string::npos) return "";
    const auto after = source.rfind('\n', last) + 1;
    return unindented(source.substr(first + begin.size(), after - first - begin.size()));
}

}  // namespace

TEST_CASE("code in the texts is the code that is tested") {
    // <!-- code FILE PART --> stands before a block that must be that part of that file, to the letter.
    const std::regex marker{"<!-- code (\\S+) (\\S+) -->\n```cpp\n"};
    int blocks = 0;
    for (const auto& entry : fs::recursive_directory_iterator{root}) {
        const std::string path = fs::relative(entry.path(), root).generic_string();
        if (entry.path().extension() != ".md" || starts_with(path, "build/")) continue;
        const std::string text = read(entry.path());
        for (std::sregex_iterator match{text.begin(), text.end(), marker}, end; match != end; ++match) {
            INFO(path << ": " << (*match)[1] << " " << (*match)[2]);
            const std::string expected = part_of(read(root / (*match)[1].str()), (*match)[2]);
            const auto begin = static_cast<std::size_t>(match->position() + match->length());
            CHECK(!expected.empty());
            CHECK(text.substr(begin, expected.size() + 4) == expected + "```\n");
            ++blocks;
        }
    }
    CHECK(blocks >= 8);
}
