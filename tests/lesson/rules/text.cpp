#include "tests/lesson/rules/text.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace lesson {

namespace {

std::size_t run_of(char letter, const std::string& text, std::size_t from) {
    std::size_t length = 0;
    while (from + length < text.size() && text[from + length] == letter) ++length;
    return length;
}

/// Where the run of exactly as many backticks as at `from` begins, behind them; npos if there is none.
std::size_t end_of_code(const std::string& text, std::size_t from) {
    const std::size_t length = run_of('`', text, from);
    for (std::size_t k = text.find('`', from + length); k != std::string::npos; k = text.find('`', k)) {
        const std::size_t found = run_of('`', text, k);
        if (found == length) return k;
        k += found;
    }
    return std::string::npos;
}

/// The line without comments, which may have begun before it; those in code are none.
std::string without_comments(const std::string& line, bool& in_comment) {
    std::string left;
    std::size_t k = 0;
    while (k < line.size()) {
        if (in_comment) {
            const std::size_t end = line.find("-->", k);
            in_comment = end == std::string::npos;
            k = in_comment ? line.size() : end + 3;
        } else if (line.compare(k, 4, "<!--") == 0) {
            in_comment = true;
            k += 4;
        } else {
            const std::size_t ticks = run_of('`', line, k);
            const std::size_t end = ticks > 0 ? end_of_code(line, k) : std::string::npos;
            const std::size_t next =
                end != std::string::npos ? end + ticks : k + std::max<std::size_t>(ticks, 1);
            left += line.substr(k, next - k);
            k = next;
        }
    }
    return left;
}

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}
std::string without_quote(const std::string& line) {
    if (!starts_with(line, ">")) return line;
    return line.substr(starts_with(line, "> ") ? 2 : 1);
}
Kind kind_of(const std::string& content) {
    if (starts_with(content, "|")) return Kind::table;
    return starts_with(content, "![") ? Kind::image : Kind::paragraph;
}

/// Reads a text line by line.
class Reader {
  public:
    void read(const std::string& line) {
        ++number_;
        const std::string content = trimmed(without_quote(line));
        if (fence_ > 0) {
            inside_fence(line, content);
        } else if (!in_comment_ && starts_with(content, "```")) {
            open_fence(content);
        } else {
            outside_fence(line);
        }
        before_ = line;
    }
    std::vector<Block> blocks;

  private:
    void inside_fence(const std::string& line, const std::string& content) {
        if (run_of('`', content, 0) == content.size() && content.size() >= fence_)
            fence_ = 0;
        else
            blocks.back().text += without_quote(line) + "\n";
    }
    void open_fence(const std::string& content) {
        fence_ = run_of('`', content, 0);
        open_ = false;
        blocks.push_back({Kind::fence, number_});
        blocks.back().info = trimmed(content.substr(fence_));
        blocks.back().marker = before_;
    }
    void outside_fence(const std::string& line) {
        const std::string left = without_comments(line, in_comment_);
        const std::string content = trimmed(without_quote(left));
        if (content.empty()) {
            // A comment on a line of its own does not end a paragraph.
            open_ = open_ && !trimmed(line).empty() && line != left && blocks.back().kind == Kind::paragraph;
            if (open_) blocks.back().text += "\n";
        } else if (const std::size_t level = run_of('#', left, 0);
                   level > 0 && left.compare(level, 1, " ") == 0) {
            blocks.push_back({Kind::heading, number_, trimmed(left.substr(level)), static_cast<int>(level)});
            open_ = false;
        } else {
            const Kind kind = kind_of(content);
            const bool quoted = starts_with(left, ">"), was_quoted = starts_with(before_, ">");
            if (!open_ || blocks.back().kind != kind || kind == Kind::image || begins_item(content) ||
                quoted != was_quoted) {
                blocks.push_back({kind, number_});
                blocks.back().opens_quote = quoted && !was_quoted;
            }
            blocks.back().text += without_quote(left) + "\n";
            open_ = true;
        }
    }

    int number_ = 0;
    std::size_t fence_ = 0;  // the backticks of the open fence
    bool open_ = false, in_comment_ = false;
    std::string before_;
};

}  // namespace

std::vector<Block> blocks_of(const std::string& markdown) {
    Reader reader;
    std::istringstream stream{markdown};
    for (std::string line; std::getline(stream, line);) reader.read(line);
    return reader.blocks;
}

std::vector<Section> sections_of(std::span<const Block> blocks, int level) {
    std::vector<Section> found;
    std::size_t first = 0;
    bool open = false;
    for (std::size_t k = 0; k <= blocks.size(); ++k) {
        const bool ends = k == blocks.size() || (blocks[k].kind == Kind::heading && blocks[k].level <= level);
        if (!ends) continue;
        if (open) found.back().blocks = blocks.subspan(first, k - first);
        open = k < blocks.size() && blocks[k].level == level;
        if (open) found.push_back({blocks[k].text, blocks[k].line, {}});
        first = k + 1;
    }
    return found;
}

std::span<const Block> opening_of(std::span<const Block> blocks) {
    const auto first = std::find_if(blocks.begin(), blocks.end(), [](const Block& block) {
        return block.kind == Kind::heading && block.level == 2;
    });
    return blocks.first(static_cast<std::size_t>(first - blocks.begin()));
}

Inline inside(const std::string& text) {
    Inline found;
    const auto blank = [&](const std::string& part) {
        found.words += ' ';
        for (const char letter : part) {
            if (letter == '\n') found.words += letter;
        }
    };
    for (std::size_t k = 0; k < text.size();) {
        const std::size_t ticks = run_of('`', text, k),
                          end = ticks > 0 ? end_of_code(text, k) : std::string::npos;
        const std::size_t close = text.compare(k, 2, "$`") == 0 ? text.find("`$", k + 2) : std::string::npos;
        if (close != std::string::npos) {
            const std::string tex = text.substr(k + 2, close - k - 2);
            found.formulas.emplace_back(count_lines(found.words), in_one_line(tex));
            blank(tex);
            k = close + 2;
        } else if (end != std::string::npos) {
            found.codes.push_back(in_one_line(text.substr(k + ticks, end - k - ticks)));
            blank(text.substr(k, end - k));
            k = end + ticks;
        } else {
            const std::size_t length = std::max<std::size_t>(ticks, text[k] == '\\' ? 2 : 1);
            if (text[k] == '$') found.dollars.push_back(count_lines(found.words));
            found.words += text.substr(k, length);
            k += length;
        }
    }
    return found;
}

std::string in_one_line(const std::string& text) {
    std::istringstream stream{text};
    std::string line;
    for (std::string word; stream >> word;) line += (line.empty() ? "" : " ") + word;
    return line;
}
bool starts_with(const std::string& text, const std::string& prefix) {
    return text.rfind(prefix, 0) == 0;
}
bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}
int count_lines(const std::string& text) {
    return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}
bool begins_item(const std::string& text) {
    if (starts_with(text, "- ") || starts_with(text, "* ")) return true;
    const std::size_t digits = text.find_first_not_of("0123456789");
    return digits != 0 && digits != std::string::npos && text.compare(digits, 2, ". ") == 0;
}

}  // namespace lesson
