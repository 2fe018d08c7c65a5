#include "common/report/claims.hpp"

#include <algorithm>
#include <stdexcept>

namespace report {
namespace {

/// A comment of the text that opens or closes a marked part; `name` is empty where it closes.
struct Mark {
    bool claim = false, closes = false;
    std::string name{};
};

/// The marks of a text in its order. (`<!-- code ... -->` has no end, and is none.)
std::vector<Mark> marks_of(const std::string& markdown) {
    const std::string open = "<!-- ", close = " -->";
    std::vector<Mark> marks;
    for (std::size_t at = 0; (at = markdown.find(open, at)) != std::string::npos;) {
        const std::size_t begin = at + open.size(), end = markdown.find(close, begin);
        if (end == std::string::npos) break;
        const std::string words = markdown.substr(begin, end - begin);
        if (words == "end") {
            marks.push_back({.closes = true});
        } else if (words == "claim" || words.starts_with("claim ")) {
            marks.push_back({.claim = true, .name = words.substr(std::min<std::size_t>(words.size(), 6))});
        } else if (words.starts_with("fill ")) {
            marks.push_back({.name = words.substr(5)});
        }
        at = end + close.size();
    }
    return marks;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::vector<std::string> claims_of(const std::string& markdown) {
    std::vector<std::string> names;
    std::vector<Mark> open;
    for (const Mark& mark : marks_of(markdown)) {
        if (mark.closes) {
            if (!open.empty()) open.pop_back();
            continue;
        }
        if (mark.claim && (mark.name.empty() || mark.name.find_first_of(" \n") != std::string::npos))
            throw std::invalid_argument{"a claim without a name: <!-- claim NAME --> is needed"};
        if (mark.claim && !open.empty())
            throw std::invalid_argument{"<!-- claim " + mark.name + " --> stands inside " + open.back().name};
        if (mark.claim && !contains(names, mark.name)) names.push_back(mark.name);
        open.push_back(mark);
    }
    if (!open.empty()) throw std::invalid_argument{open.back().name + " has no <!-- end -->"};
    return names;
}

std::vector<std::string> broken_claims(const std::string& chapter, const std::string& book,
                                       const std::string& number, const Claims& asserted) {
    std::vector<std::string> lines, told = claims_of(chapter);
    for (const std::string& name : claims_of(book)) {
        if (name.starts_with(number + ":")) told.push_back(name.substr(number.size() + 1));
    }
    for (const std::string& name : told) {
        if (!asserted.contains(name))
            lines.push_back("claim " + name + ": stands in the text, but nothing asserts it");
    }
    for (const auto& [name, verdict] : asserted) {
        if (!contains(told, name))
            lines.push_back("claim " + name + ": is asserted, but does not stand in the text");
        if (verdict == Verdict::fails) lines.push_back("claim " + name + ": does not hold");
    }
    return lines;
}

std::string names_with(Verdict verdict, const Claims& claims) {
    std::string names;
    for (const auto& [name, found] : claims) {
        if (found == verdict) names += (names.empty() ? "" : ", ") + name;
    }
    return names;
}

}  // namespace report
