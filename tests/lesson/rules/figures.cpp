// Rules of figures: what a caption says, and that a problem is told before its first result.
#include <algorithm>
#include <cctype>
#include <optional>
#include <regex>

#include "tests/lesson/rules/lesson.hpp"

namespace lesson {

namespace {

constexpr std::size_t shortest_caption = 60;

/// "*Figure 4.2.*" or "*Figure 4.2, a drawing.*"
struct Head {
    std::string number;
    bool drawing = false;
    std::size_t length = 0;
};
std::optional<Head> head_of(const std::string& caption) {
    static const std::regex form{"\\*Figure ([0-9]+\\.[0-9]+)(, a drawing)?\\.\\* "};
    std::smatch match;
    const std::string front = caption.substr(0, 40);
    if (!std::regex_search(front, match, form, std::regex_constants::match_continuous)) return {};
    return Head{match[1], match[2].matched, static_cast<std::size_t>(match.length())};
}

/// The name of the figure in "![alt](../../renders/FOLDER/NAME.png)", "" if the line has another form.
std::string name_of(const std::string& image, const std::string& folder) {
    const std::regex form{"!\\[[^\\]]*\\]\\(\\.\\./\\.\\./renders/" + folder +
                          "/([a-z0-9-]+)\\.(png|webp)\\)"};
    std::smatch match;
    const std::string line = in_one_line(image);
    return line.size() < 1000 && std::regex_match(line, match, form) ? match[1].str() : "";
}

std::size_t letters(const std::string& utf8) {
    return static_cast<std::size_t>(std::count_if(utf8.begin(), utf8.end(), [](char byte) {
        return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
    }));
}

/// What remains of a caption without its head, code and the link to `target`.
std::size_t letters_of_its_own(const std::string& caption, std::size_t head, const std::string& target) {
    std::string left = caption.substr(head);
    const std::size_t link = left.find(target);
    if (link != std::string::npos) {
        const std::size_t first = left.rfind('[', link);
        if (first != std::string::npos) left.erase(first, link + target.size() - first);
    }
    return letters(in_one_line(inside(left).words));
}

bool runs(const std::vector<std::string>& codes, const std::string& command) {
    return std::any_of(codes.begin(), codes.end(), [&](const std::string& code) {
        return code == command || starts_with(code, command + " ");
    });
}

struct Figure {
    const Block* image = nullptr;
    const Block* caption = nullptr;  // the block behind it, if there is one
};
std::vector<Figure> figures_of(std::span<const Block> blocks) {
    std::vector<Figure> found;
    for (std::size_t k = 0; k < blocks.size(); ++k) {
        if (blocks[k].kind == Kind::image)
            found.push_back({&blocks[k], k + 1 < blocks.size() ? &blocks[k + 1] : nullptr});
    }
    return found;
}
bool is_drawing(const Figure& figure) {
    const auto head = figure.caption ? head_of(in_one_line(figure.caption->text)) : std::nullopt;
    return head && head->drawing;
}

void check_caption(const Lesson& lesson, const Figure& figure, const std::string& number,
                   Breaches& breaches) {
    const int line = figure.image->line;
    const std::string caption =
        figure.caption && figure.caption->kind == Kind::paragraph ? in_one_line(figure.caption->text) : "";
    const auto head = head_of(caption);
    if (!head || head->number != number)
        return breaches.add(line, "behind the picture stands no caption \"*Figure " + number + ".* ...\"");
    const std::string name = name_of(figure.image->text, lesson.folder);
    if (name.empty()) return;
    const std::string command = "./tutorial run " + lesson.number + " --only " + name;
    const std::string csv = "](../../renders/" + lesson.folder + "/" + name + ".csv)";
    if (!runs(inside(caption).codes, command))
        breaches.add(line, "the caption lacks the command `" + command + "`");
    if (!contains(caption, csv)) breaches.add(line, "the caption lacks the link [...]" + csv.substr(1));
    const std::size_t own = letters_of_its_own(caption, head->length, csv);
    if (own < shortest_caption)
        breaches.add(line,
                     "the caption says no more than " + std::to_string(own) + " letters besides its command");
}

/// Whether the problem is told, or another figure named that has the same.
bool tells_a_problem(std::span<const Block> blocks) {
    for (const Block& block : blocks) {
        if (block.kind != Kind::paragraph) continue;
        const std::string text = in_one_line(block.text);
        if (block.opens_quote && starts_with(text, "**Problem: ")) return true;
        if (contains(text, "ame problem as in Figure ") || contains(text, "he problem of Figure "))
            return true;
    }
    return false;
}

/// "Figure 4.9" where the chapter has no such figure.
void check_mentions(const Lesson& lesson, int figures, Breaches& breaches) {
    const std::string mention = "Figure " + lesson.chapter + ".";
    for (const Block& block : lesson.blocks) {
        if (block.kind == Kind::fence) continue;
        std::string words = inside(block.text).words;
        std::replace(words.begin(), words.end(), '\n', ' ');
        for (std::size_t k = words.find(mention); k != std::string::npos; k = words.find(mention, k + 1)) {
            const int number = std::atoi(words.c_str() + k + mention.size());
            if (number < 1 || number > figures)
                breaches.add(block.line, "there is no " + mention + std::to_string(number));
        }
    }
}

}  // namespace

void check_figures(const Lesson& lesson, Breaches& breaches) {
    int count = 0;
    for (const Figure& figure : figures_of(lesson.blocks)) {
        const int line = figure.image->line;
        if (name_of(figure.image->text, lesson.folder).empty())
            breaches.add(line, "a picture is ![...](../../renders/" + lesson.folder + "/NAME.png), or .webp");
        if (starts_with(figure.image->text, "![]")) breaches.add(line, "a picture without alternative text");
        check_caption(lesson, figure, lesson.chapter + "." + std::to_string(++count), breaches);
    }
    for (const Block& block : lesson.blocks) {
        if (block.kind == Kind::fence || block.kind == Kind::image) continue;
        const std::string words = inside(block.text).words;
        if (contains(words, "![") || contains(words, "<img"))
            breaches.add(block.line, "a picture stands on a line of its own, ![...](...)");
    }
    check_mentions(lesson, count, breaches);
}

void check_problems(const Lesson& lesson, Breaches& breaches) {
    for (const Section& section : sections_of(lesson.blocks, 2)) {
        for (const Figure& figure : figures_of(section.blocks)) {
            if (is_drawing(figure)) continue;
            const auto before = static_cast<std::size_t>(figure.image - section.blocks.data());
            if (!tells_a_problem(section.blocks.first(before)))
                breaches.add(figure.image->line, "before the first result of \"" + section.title +
                                                     "\" stands no box \"> **Problem: \"");
            break;
        }
    }
}

}  // namespace lesson
