#pragma once
#include <span>
#include <string>
#include <vector>

#include "tests/lesson/rules/text.hpp"

namespace lesson {

/// A chapter's text and whose it is.
struct Lesson {
    Lesson(const std::string& text, const std::string& chapter);

    std::string markdown;
    std::string folder;   // "04_artificial_viscosity"
    std::string number;   // "04"
    std::string chapter;  // "4", as in (4.1) and Figure 4.1
    std::vector<Block> blocks;

    std::span<const Block> story() const;  ///< what stands before the appendix
};

/// What is wrong with a text: "README.md:LINE: what".
struct Breaches {
    std::vector<std::string> found;
    void add(int line, const std::string& what);
};

/// All breaches of the rules of a lesson in `markdown`, the text of the chapter in the folder of that name.
std::vector<std::string> breaches(const std::string& markdown, const std::string& folder);

/// Words before the appendix, outside code, comments, tables and displayed formulas.
int word_count(const std::string& markdown);

inline constexpr int words_end = 4500;  // a lesson has fewer

// The rules, one function each.
void check_formulas(const Lesson& lesson, Breaches& breaches);    // (N.k)
void check_code(const Lesson& lesson, Breaches& breaches);        // parts of files
void check_figures(const Lesson& lesson, Breaches& breaches);     // captions
void check_tables(const Lesson& lesson, Breaches& breaches);      // few and short
void check_problems(const Lesson& lesson, Breaches& breaches);    // a box before the first result
void check_exercises(const Lesson& lesson, Breaches& breaches);   // three, with commands and solutions
void check_objectives(const Lesson& lesson, Breaches& breaches);  // what one can do afterwards
void check_hours(const Lesson& lesson, Breaches& breaches);       // how long it takes
void check_length(const Lesson& lesson, Breaches& breaches);      // words and sections
void check_appendix(const Lesson& lesson, Breaches& breaches);    // its table of equations

}  // namespace lesson
