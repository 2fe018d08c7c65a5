#include "common/plot/markup.hpp"

#include <cstdint>

namespace plot {
namespace {

constexpr char32_t replacement = 0xFFFD;
constexpr int deepest = 3;

/// Number of bytes that follow a first byte, -1 if it cannot be first.
int followers(std::uint8_t first) {
    if (first < 0x80) return 0;
    if (first >= 0xC2 && first < 0xE0) return 1;
    if (first >= 0xE0 && first < 0xF0) return 2;
    if (first >= 0xF0 && first < 0xF5) return 3;
    return -1;
}

/// Reads one code point and moves `at` behind it, or behind one byte if that begins none.
char32_t next_code(std::string_view text, std::size_t& at) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t first = byte(at);
    const int count = followers(first);
    const std::size_t begin = at++;
    if (count <= 0) return count == 0 ? first : replacement;
    char32_t code = first & (0x3F >> count);
    for (std::size_t i = begin + 1; i <= begin + static_cast<std::size_t>(count); ++i) {
        if (i >= text.size() || (byte(i) & 0xC0) != 0x80) return replacement;
        code = (code << 6) | (byte(i) & 0x3F);
    }
    constexpr char32_t smallest[] = {0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xD800 && code < 0xE000;
    if (code < smallest[count] || code > 0x10FFFF || surrogate) return replacement;
    at = begin + 1 + static_cast<std::size_t>(count);
    return code;
}

bool is_letter(char32_t c) {
    const bool latin = (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z');
    const bool accented = c >= 0xC0 && c < 0x250 && c != 0xD7 && c != 0xF7;
    const bool greek = c >= 0x370 && c < 0x400;
    return latin || accented || greek || c == U'ℓ' || c == U'ħ';
}

class Parser {
  public:
    explicit Parser(std::u32string text) : text_{std::move(text)} {}

    /// The spans of [begin, end).
    std::vector<TextRun> parse(std::size_t begin, std::size_t end, bool italic, int depth) const {
        std::vector<TextRun> spans;
        for (std::size_t at = begin; at < end;) {
            const char32_t c = text_[at];
            if (c == U'$' && (italic || closing_dollar(at + 1, end))) {
                italic = !italic;
                ++at;
                continue;
            }
            const std::size_t close = depth < deepest ? script_end(at, end) : 0;
            if (close != 0) {
                hang(spans, c == U'_', parse(at + 2, close, italic, depth + 1), italic);
                at = close + 1;
                continue;
            }
            append(spans, c, italic && is_letter(c));
            ++at;
        }
        return spans;
    }

  private:
    static void append(std::vector<TextRun>& spans, char32_t c, bool italic) {
        const bool same = !spans.empty() && spans.back().italic == italic && spans.back().below.empty() &&
                          spans.back().above.empty();
        if (!same) spans.push_back({{}, italic, {}, {}});
        spans.back().text += c;
    }

    static void hang(std::vector<TextRun>& spans, bool below, std::vector<TextRun> script, bool italic) {
        const auto place = [below](TextRun& span) -> std::vector<TextRun>& {
            return below ? span.below : span.above;
        };
        if (spans.empty() || !place(spans.back()).empty()) spans.push_back({{}, italic, {}, {}});
        place(spans.back()) = std::move(script);
    }

    /// Whether a `$` follows at the same depth of braces.
    bool closing_dollar(std::size_t at, std::size_t end) const {
        for (int braces = 0; at < end; ++at) {
            if (text_[at] == U'{') ++braces;
            if (text_[at] == U'}') --braces;
            if (text_[at] == U'$' && braces == 0) return true;
        }
        return false;
    }

    /// Where the brace of a script that begins at `at` is closed; 0 if none begins there.
    std::size_t script_end(std::size_t at, std::size_t end) const {
        if ((text_[at] != U'_' && text_[at] != U'^') || at + 1 >= end || text_[at + 1] != U'{') return 0;
        int braces = 0;
        for (std::size_t i = at + 1; i < end; ++i) {
            if (text_[i] == U'{') ++braces;
            if (text_[i] == U'}' && --braces == 0) return i;
        }
        return 0;
    }

    std::u32string text_;
};

}  // namespace

std::u32string decode_utf8(std::string_view text) {
    std::u32string codes;
    for (std::size_t at = 0; at < text.size();) {
        const char32_t code = next_code(text, at);
        const bool control = code < 0x20 || (code >= 0x7F && code < 0xA0);
        codes += control ? U' ' : code;
    }
    return codes;
}

std::vector<TextRun> parse_markup(std::string_view text) {
    const std::u32string codes = decode_utf8(text);
    return Parser{codes}.parse(0, codes.size(), false, 0);
}

}  // namespace plot
