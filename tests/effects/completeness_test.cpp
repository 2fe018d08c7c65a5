// No effect, no smoothing and no part of an effect is forgotten: the sources are asked what there is.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <set>

#include "tests/effects/subjects.hpp"

using namespace sph::tested;

namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// The types of a source that have a member function which begins so. Sources are laid out by clang-format: a
/// member is indented by four more than the type that it belongs to.
Names types_with(const std::regex& function, std::istream& source) {
    const std::regex type{R"(^( *)(?:struct|class) (\w+(?:<[^>]*>)?))"}, indent{"^ *"};
    std::vector<std::string> open;  // the type that was last opened at each depth
    Names found;
    for (std::string line; std::getline(source, line);) {
        std::smatch match;
        if (std::regex_search(line, match, type)) {
            open.resize(static_cast<std::size_t>(match[1].length()) / 4);
            open.push_back(match[2]);
        } else if (std::regex_search(line, match, function)) {
            std::regex_search(line, match, indent);
            open.resize(static_cast<std::size_t>(match.length()) / 4);
            std::string name = open.at(0);
            for (std::size_t k = 1; k < open.size(); ++k) name += "::" + open[k];
            found.insert(name);
        }
    }
    return found;
}
Names types_with(const std::regex& function) {
    Names found;
    for (const auto& entry : fs::recursive_directory_iterator{fs::path{SPH_SOURCE_DIR} / "chapters"}) {
        if (entry.path().extension() != ".hpp") continue;
        std::ifstream source{entry.path()};
        found.merge(types_with(function, source));
    }
    return found;
}

const std::regex adds{R"(^ +void add\(const auto&)"};

/// The effects under test that no other effect stands in for, called as in the sources: a specialisation with
/// its arguments, an instance of a template without.
Names covered(const Names& in_sources) {
    Names names;
    for (const Subject& subject : all_subjects()) {
        if (in_sources.count(subject.name) > 0) {
            names.insert(subject.name);
        } else if (subject.name.rfind("Renamed<", 0) != 0) {
            names.insert(subject.name.substr(0, subject.name.find('<')));
        }
    }
    return names;
}

}  // namespace

TEST_CASE("every effect of the chapters is under test") {
    const Names in_sources = types_with(adds);
    CHECK(in_sources == covered(in_sources));
    CHECK(in_sources.count("ViscousForce<PairwiseViscosity>") == 1);
    CHECK(in_sources.count("CspmCurvature::Sums") == 1);
    CHECK(in_sources.size() > 35);
}

TEST_CASE("every viscosity, conduction speed, factor and Phi is under test in some effect") {
    Names parts;
    for (const char* function : {R"(^ +Tile pressure\(const auto& i)", R"(^ +Tile of\(const auto& i)",
                                 R"(^ +static (const )?auto&? of\(const auto&)"})
        parts.merge(types_with(std::regex{function}));
    for (const std::string& part : parts) {
        INFO(part);
        const std::regex argument{"[<, ]" + part + "[<>,]"};
        CHECK(std::any_of(all_subjects().begin(), all_subjects().end(),
                          [&](const Subject& subject) { return std::regex_search(subject.name, argument); }));
    }
    CHECK(parts.size() >= 14);
}

TEST_CASE("every smoothing is under test") {
    Names tested;
    for (const auto& smoothing : smoothings_with<1>("cubic")) tested.insert(smoothing.name);
    CHECK(tested == types_with(std::regex{R"( pair\(const auto&.*Vec<Tile, d>& x_ij\) const)"}));
}

TEST_CASE("the search for effects sees members, nested types and specialisations") {
    std::istringstream source{
        "struct A {\n    template <class T, int>\n    struct In {\n        T a{};\n    };\n"
        "    void add(const auto& i) const {\n    }\n};\n"
        "struct B {\n    struct Sums {\n        void add(const auto& i) const {\n    };\n};\n"
        "template <>\nstruct C<D> {\n    void add(const auto& i) const {\n};\n"
        "struct E {\n    void finish(const auto& i) const {\n};\n"};
    CHECK(types_with(adds, source) == Names{"A", "B::Sums", "C<D>"});
}
