// Rules of a lesson's form: code, tables, objectives, hours, length, appendix.
#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>

#include "tests/lesson/rules/lesson.hpp"

namespace lesson {

namespace {

constexpr int fewest_codes = 4, most_rows = 8, most_sections = 12, fewest_objectives = 3, most_objectives = 5;

/// The cells of a table's first line.
std::vector<std::string> header_of(const std::string& table) {
    std::istringstream line{table.substr(0, table.find('\n'))};
    std::vector<std::string> cells;
    std::string cell;
    std::getline(line, cell, '|');  // before the first bar
    while (std::getline(line, cell, '|')) cells.push_back(in_one_line(cell));
    return cells;
}
bool is_word(const std::string& token) {
    return token != "–" && std::any_of(token.begin(), token.end(), [](char letter) {
               return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
                      static_cast<unsigned char>(letter) >= 0x80;
           });
}
int words_of(std::span<const Block> blocks) {
    int count = 0;
    for (const Block& block : blocks) {
        if (block.kind == Kind::fence || block.kind == Kind::table) continue;
        std::istringstream words{block.text};
        for (std::string word; words >> word;) count += is_word(word);
    }
    return count;
}

}  // namespace

void check_code(const Lesson& lesson, Breaches& breaches) {
    const std::regex marker{"<!-- code \\S+ \\S+ -->"};
    const auto shown = std::count_if(lesson.blocks.begin(), lesson.blocks.end(), [&](const Block& block) {
        return block.kind == Kind::fence && block.info == "cpp" && std::regex_match(block.marker, marker);
    });
    if (shown < fewest_codes)
        breaches.add(1,
                     "shows " + std::to_string(shown) +
                         " parts of files; at least four blocks ```cpp stand behind <!-- code FILE PART -->");
}

void check_tables(const Lesson& lesson, Breaches& breaches) {
    int tables = 0;  // of this section
    for (const Block& block : lesson.story()) {
        if (block.kind == Kind::heading && block.level <= 3) tables = 0;
        if (block.kind != Kind::table) continue;
        const int rows = count_lines(block.text) - 2;
        if (rows > most_rows)
            breaches.add(block.line, "a table of " + std::to_string(rows) +
                                         " rows; more than eight belong into the appendix or the CSV");
        if (++tables > 1) breaches.add(block.line, "a second table in one section");
    }
}

void check_objectives(const Lesson& lesson, Breaches& breaches) {
    const auto opening = opening_of(lesson.blocks);
    const auto said = std::find_if(opening.begin(), opening.end(), [](const Block& block) {
        return block.kind == Kind::paragraph &&
               contains(in_one_line(block.text), "After this chapter you can");
    });
    if (said == opening.end())
        return breaches.add(1, "no \"After this chapter you can\" before the first section");
    int items = 0;
    for (auto block = said + 1; block != opening.end() && block->kind == Kind::paragraph; ++block) {
        if (starts_with(block->text, "  ")) continue;  // an item of an item
        if (!begins_item(block->text)) break;
        ++items;
    }
    if (items < fewest_objectives || items > most_objectives)
        breaches.add(said->line, "three to five items follow \"After this chapter you can\", not " +
                                     std::to_string(items));
}

void check_hours(const Lesson& lesson, Breaches& breaches) {
    for (const Block& block : opening_of(lesson.blocks)) {
        std::istringstream lines{block.kind == Kind::paragraph ? block.text : ""};
        for (std::string line; std::getline(lines, line);) {
            if (contains(line, "Reading:") && contains(line, "Running:")) return;
        }
    }
    breaches.add(1, "no line with \"Reading:\" and \"Running:\" before the first section");
}

int word_count(const std::string& markdown) {
    return words_of(Lesson{markdown, "00"}.story());
}

void check_length(const Lesson& lesson, Breaches& breaches) {
    const int words = words_of(lesson.story());
    if (words >= words_end)
        breaches.add(1, std::to_string(words) + " words before the appendix, not fewer than " +
                            std::to_string(words_end));
    const auto sections = sections_of(lesson.story(), 2).size();
    if (sections > most_sections)
        breaches.add(1, std::to_string(sections) + " sections before the appendix, more than twelve");
}

void check_appendix(const Lesson& lesson, Breaches& breaches) {
    const auto rest = std::span{lesson.blocks}.subspan(lesson.story().size());
    const auto sections = sections_of(rest, 2);
    if (sections.empty()) return breaches.add(1, "no section \"## Appendix\"");
    if (sections.size() > 1) breaches.add(sections[1].line, "a section behind the appendix");
    for (const Section& part : sections_of(sections[0].blocks, 3)) {
        std::string title = part.title;
        std::transform(title.begin(), title.end(), title.begin(),
                       [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
        if (!contains(title, "equations")) continue;
        for (const Block& block : part.blocks) {
            if (block.kind == Kind::table &&
                header_of(block.text) == std::vector<std::string>{"equation", "function", "file"})
                return;
        }
    }
    breaches.add(sections[0].line,
                 "the appendix has no \"### ... equations ...\" with a table | equation | function | file |");
}

}  // namespace lesson
