// The rooms of a chapter: ideas on its top, scenes and figures below, and one name for one thing.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/structure/tracked.hpp"

namespace {

namespace fs = std::filesystem;
const fs::path root{SPH_SOURCE_DIR};

std::vector<fs::path> chapters() {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator{root / "chapters"}) {
        if (structure::is_ours(entry.path(), true)) found.push_back(entry.path());
    }
    return found;
}
std::string read(const fs::path& path) {
    std::ifstream stream{path};
    return {std::istreambuf_iterator<char>{stream}, {}};
}
bool is_source(const fs::path& path) {
    return path.extension() == ".hpp" || path.extension() == ".cpp";
}
template <class Visit>
void for_each_source(const fs::path& folder, Visit&& visit) {
    for (const auto& entry : fs::recursive_directory_iterator{folder}) {
        if (is_source(entry.path())) visit(entry.path());
    }
}

/// The types that a source defines in named namespaces: "sph::euler::WaveScene". Code is laid out by
/// clang-format: namespaces and their types begin in the first column.
std::set<std::string> types_of(std::istream& source) {
    const std::regex opens{R"(^namespace ([a-z_:]+) \{)"}, closes{R"(^\}  // namespace ?([a-z_:]*))"};
    const std::regex type{R"(^(struct|class|enum class) ([A-Z]\w*)( :.*| \{.*|$))"};
    std::string scope;
    bool anonymous = false;
    std::set<std::string> found;
    for (std::string line; std::getline(source, line);) {
        std::smatch match;
        if (std::regex_search(line, match, opens)) {
            scope += match[1].str() + "::";
        } else if (line.rfind("namespace {", 0) == 0) {
            anonymous = true;
        } else if (std::regex_search(line, match, closes)) {
            if (match[1].length() == 0)
                anonymous = false;
            else
                scope.resize(scope.size() - static_cast<std::size_t>(match[1].length()) - 2);
        } else if (!anonymous && std::regex_search(line, match, type)) {
            found.insert(scope + match[2].str());
        }
    }
    return found;
}
std::set<std::string> types_of(const std::string& source) {
    std::istringstream stream{source};
    return types_of(stream);
}

}  // namespace

TEST_CASE("a type is defined in one file of the chapters only") {
    std::map<std::string, std::string> where;
    for_each_source(root / "chapters", [&](const fs::path& path) {
        for (const std::string& type : types_of(read(path))) {
            INFO(type << " in " << path << " and " << where[type]);
            CHECK(where[type].empty());
            where[type] = path.string();
        }
    });
    CHECK(where.size() > 150);
    CHECK(where.count("sph::GradHForce") == 1);
}

TEST_CASE("the check of types sees them, and what is none of its business") {
    const std::string source =
        "namespace sph {\nstruct A {\n    struct Inner {};\n};\ntemplate <class T>\nclass B : public A "
        "{\n};\n"
        "struct C;\nnamespace {\nstruct D {\n};\n}  // namespace\ntemplate <>\nstruct B<int> {\n};\n"
        "}  // namespace sph\nnamespace sph::x {\nenum class E { a };\n}  // namespace sph::x\n";
    CHECK(types_of(source) == std::set<std::string>{"sph::A", "sph::B", "sph::x::E"});
}

TEST_CASE("a chapter's top holds what is taught: headers, text, program, and at most twelve files") {
    for (const fs::path& chapter : chapters()) {
        INFO(chapter);
        int files = 0;
        for (const auto& entry : fs::directory_iterator{chapter}) {
            const std::string name = entry.path().filename().string();
            if (!structure::is_ours(entry.path(), true)) continue;
            INFO(name);
            if (entry.is_directory()) {
                CHECK((name == "scenes" || name == "figures"));
                continue;
            }
            ++files;
            CHECK((entry.path().extension() == ".hpp" || name == "README.md" || name == "main.cpp" ||
                   name == "CMakeLists.txt"));
        }
        CHECK(files <= 12);
    }
}

TEST_CASE("physics stands in sph, scenes and figures in a namespace of their chapter") {
    for (const fs::path& chapter : chapters()) {
        for (const char* room : {"scenes", "figures"}) {
            for_each_source(chapter / room, [&](const fs::path& path) {
                for (const std::string& type : types_of(read(path))) {
                    INFO(path << ": " << type);
                    CHECK(std::regex_match(type, std::regex{"sph::[a-z_]+::\\w+"}));
                }
            });
        }
    }
}

TEST_CASE("each figure stands in a file of its name, draws only, and is shown in the text") {
    int figures = 0;
    for (const fs::path& chapter : chapters()) {
        const std::string main = read(chapter / "main.cpp"), text = read(chapter / "README.md");
        const std::regex declared{R"re(figure\("([a-z0-9-]+)")re"};
        for (std::sregex_iterator match{main.begin(), main.end(), declared}, end; match != end; ++match) {
            std::string file = (*match)[1].str() + ".cpp";
            std::replace(file.begin(), file.end(), '-', '_');
            INFO(chapter << ": " << file);
            CHECK(fs::exists(chapter / "figures" / file));
            std::string picture = chapter.filename().string() + "/" + (*match)[1].str() + ".png";
            if (!fs::exists(root / "renders" / picture))  // an animation
                picture.replace(picture.size() - 3, 3, "webp");
            CHECK(fs::exists(root / "renders" / picture));
            CHECK(text.find("renders/" + picture) != std::string::npos);
            ++figures;
        }
        for_each_source(chapter / "figures", [&](const fs::path& path) {
            INFO(path);
            CHECK(read(path).find("#include \"common/core/pass.hpp\"") == std::string::npos);
        });
    }
    CHECK(figures > 50);
}

TEST_CASE("one time loop: nobody but march() makes steps") {
    const std::regex step{R"((\.|->)step\()"};
    for (const char* folder : {"chapters", "common"}) {
        for_each_source(root / folder, [&](const fs::path& path) {
            const std::string name = fs::relative(path, root).generic_string();
            // An integrator is what a simulation's step() is; exact/ knows no SPH.
            if (name == "common/core/march.cpp" || name == "common/core/integrated.hpp" ||
                name.rfind("common/exact/", 0) == 0)
                return;
            INFO(name);
            CHECK(!std::regex_search(read(path), step));
        });
    }
}
