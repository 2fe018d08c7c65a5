#include "tests/lesson/rules/formulas.hpp"

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>

#include "tests/lesson/rules/lesson.hpp"

namespace lesson {

namespace {

/// What GitHub does not draw ("The following macros are not allowed"), although MathJax and pandoc would.
constexpr std::array refused{"\\operatorname", "\\mbox", "\\phantom", "\\def", "\\newcommand"};

bool is_display(const Block& block) {
    return block.kind == Kind::fence && block.info == "math";
}

/// "4.2" at the end of the formula's \tag{4.2}, "" if it does not end with one.
std::string tag_of(const std::string& tex) {
    const std::string line = in_one_line(tex);
    const std::size_t first = line.rfind("\\tag{");
    if (first == std::string::npos || line.find('}', first) != line.size() - 1) return "";
    return line.substr(first + 5, line.size() - first - 6);
}

/// The numbers in "4.2", "4.2, 4.3" and "4.2–4.4"; none if anything else stands there.
std::vector<Reference> numbers_in(const std::string& text, int line) {
    std::vector<Reference> found;
    if (text.size() > 60) return found;
    static const std::regex number{"([0-9]+)\\.([0-9]{1,3})"};
    static const std::regex group{"[0-9]+\\.[0-9]{1,3}((, ?| and |, and | to |–|-)[0-9]+\\.[0-9]{1,3})*"};
    if (!std::regex_match(text, group)) return found;
    for (std::sregex_iterator match{text.begin(), text.end(), number}, end; match != end; ++match)
        found.push_back({line, (*match)[1], std::stoi((*match)[2])});
    return found;
}

void check_displays(const Lesson& lesson, Breaches& breaches) {
    int next = 1;
    for (const Block& block : lesson.blocks) {
        if (!is_display(block)) continue;
        if (count_lines(block.text) != 1) breaches.add(block.line, "a display is one line of TeX");
        const std::string wanted = lesson.chapter + "." + std::to_string(next++), tag = tag_of(block.text);
        if (tag != wanted)
            breaches.add(block.line, "the display ends with " +
                                         (tag.empty() ? "no \\tag" : "\\tag{" + tag + "}") +
                                         ", not with \\tag{" + wanted + "}");
    }
    if (next == 1) breaches.add(1, "no displayed equation (```math)");
}

void check_dollars(const Lesson& lesson, Breaches& breaches) {
    std::istringstream lines{lesson.markdown};
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (contains(line, "$$")) breaches.add(number, "$$; a display is a fence ```math");
    }
    for (const Block& block : lesson.blocks) {
        if (block.kind == Kind::fence || contains(block.text, "$$")) continue;
        for (const int line : inside(block.text).dollars)
            breaches.add(block.line + line, "a dollar that belongs to no formula $`...`$");
    }
}

}  // namespace

std::vector<Formula> formulas_of(const std::string& markdown) {
    std::vector<Formula> found;
    for (const Block& block : blocks_of(markdown)) {
        if (is_display(block)) found.push_back({block.line, in_one_line(block.text)});
        if (block.kind == Kind::fence) continue;
        for (const auto& [line, tex] : inside(block.text).formulas) found.push_back({block.line + line, tex});
    }
    return found;
}

std::vector<Reference> references_of(const std::vector<Block>& blocks) {
    std::vector<Reference> found;
    for (const Block& block : blocks) {
        if (block.kind == Kind::fence) continue;
        const std::string words = inside(block.text).words;
        for (std::size_t k = words.find('('); k != std::string::npos; k = words.find('(', k + 1)) {
            const std::size_t end = words.find(')', k);
            if (end == std::string::npos) break;
            const int line = block.line + count_lines(words.substr(0, k));
            for (const Reference& one : numbers_in(in_one_line(words.substr(k + 1, end - k - 1)), line))
                found.push_back(one);
        }
    }
    return found;
}

std::vector<Reference> tags_of(const std::vector<Block>& blocks) {
    std::vector<Reference> found;
    for (const Block& block : blocks) {
        if (!is_display(block)) continue;
        for (const Reference& tag : numbers_in(tag_of(block.text), block.line)) found.push_back(tag);
    }
    return found;
}

void check_formulas(const Lesson& lesson, Breaches& breaches) {
    check_displays(lesson, breaches);
    check_dollars(lesson, breaches);
    const auto displays = std::count_if(lesson.blocks.begin(), lesson.blocks.end(), is_display);
    for (const Reference& reference : references_of(lesson.blocks)) {
        if (reference.chapter == lesson.chapter && (reference.number < 1 || reference.number > displays))
            breaches.add(reference.line, "no equation has the number (" + lesson.chapter + "." +
                                             std::to_string(reference.number) + ")");
    }
    for (const Formula& formula : formulas_of(lesson.markdown)) {
        for (const char* macro : refused) {
            if (contains(formula.tex, macro))
                breaches.add(formula.line, std::string{"GitHub refuses "} + macro);
        }
    }
}

}  // namespace lesson
