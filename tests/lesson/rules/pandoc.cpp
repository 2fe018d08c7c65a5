#include "tests/lesson/rules/pandoc.hpp"

#include <fstream>

#include "tests/lesson/rules/shell.hpp"

namespace lesson {

namespace {

constexpr const char* command = "pandoc -f markdown --mathml --fail-if-warnings formulas.md";

Outcome pandoc(const std::vector<std::string>& formulas) {
    const TemporaryFolder folder;
    {
        std::ofstream text{folder.path / "formulas.md"};
        for (const std::string& formula : formulas) text << "$$" << formula << "$$\n\n";
    }
    return run_in(folder.path, command);
}
std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t k = text.find(part); k != std::string::npos; k = text.find(part, k + 1)) ++found;
    return found;
}

}  // namespace

bool has_pandoc() {
    return run_in(".", "command -v pandoc").status == 0;
}
bool reads(const std::vector<std::string>& formulas) {
    const Outcome outcome = pandoc(formulas);
    // What Markdown takes for words gives no warning, and no formula.
    return outcome.status == 0 && count(outcome.text, "<math ") == formulas.size();
}
std::string complaint_of(const std::string& formula) {
    const Outcome outcome = pandoc({formula});
    return outcome.status != 0 ? outcome.text : "this is no formula for pandoc";
}

}  // namespace lesson
