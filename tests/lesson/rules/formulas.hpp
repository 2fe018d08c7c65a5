#pragma once
#include <string>
#include <vector>

#include "tests/lesson/rules/text.hpp"

namespace lesson {

/// Displayed (a fence ```math) or inside a line ($`...`$).
struct Formula {
    int line = 0;
    std::string tex;
};
std::vector<Formula> formulas_of(const std::string& markdown);

/// "(4.2)" in a text is a reference to 4, 2; so are both numbers of "(4.2, 4.3)".
struct Reference {
    int line = 0;
    std::string chapter;
    int number = 0;
};
std::vector<Reference> references_of(const std::vector<Block>& blocks);
/// Displayed equations by what stands in their \tag{4.2}.
std::vector<Reference> tags_of(const std::vector<Block>& blocks);

}  // namespace lesson
