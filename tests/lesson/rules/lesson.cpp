#include "tests/lesson/rules/lesson.hpp"

#include <algorithm>

namespace lesson {

Lesson::Lesson(const std::string& text, const std::string& name)
    : markdown{text},
      folder{name},
      number{name.substr(0, 2)},
      chapter{std::to_string(std::stoi(number))},
      blocks{blocks_of(text)} {}

std::span<const Block> Lesson::story() const {
    const auto end = std::find_if(blocks.begin(), blocks.end(), [](const Block& block) {
        return block.kind == Kind::heading && block.level == 2 && starts_with(block.text, "Appendix");
    });
    return {blocks.begin(), end};
}

void Breaches::add(int line, const std::string& what) {
    found.push_back("README.md:" + std::to_string(line) + ": " + what);
}

std::vector<std::string> breaches(const std::string& markdown, const std::string& folder) {
    const Lesson lesson{markdown, folder};
    Breaches all;
    for (const auto rule : {check_formulas, check_code, check_figures, check_tables, check_problems,
                            check_exercises, check_objectives, check_hours, check_length, check_appendix}) {
        rule(lesson, all);
    }
    return all.found;
}

}  // namespace lesson
