#include "common/report/words.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "common/report/text.hpp"

namespace report::words {
namespace {

/// Both smaller than this: nothing but the rounding of double precision at values of order one.
constexpr double rounding_noise = 1e-13;
constexpr std::string_view about = "≈";

/// A piece of a line: a number with the unit of its last digit, a timing, or the text between them.
struct Token {
    enum class Kind { text, number, timing } kind;
    std::string text;
    double value = 0, unit = 0;
};

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
/// What makes digits beside it part of a name; bytes of UTF-8 above 127 may be signs such as "×".
bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// Length of the number at the beginning of `text`: sign, digits, point, digits, exponent; 0: none.
std::size_t number_length(std::string_view text) {
    std::size_t k = 0;
    const auto digits = [&] {
        const std::size_t begin = k;
        while (k < text.size() && is_digit(text[k])) ++k;
        return k - begin;
    };
    if (k < text.size() && (text[k] == '-' || text[k] == '+')) ++k;
    if (digits() == 0) return 0;
    // A point without digits after it ends a sentence.
    if (k + 1 < text.size() && text[k] == '.' && is_digit(text[k + 1])) {
        ++k;
        digits();
    }
    const std::size_t mantissa = k;
    if (k < text.size() && text[k] == 'e') {
        ++k;
        if (k < text.size() && (text[k] == '-' || text[k] == '+')) ++k;
        if (digits() == 0) k = mantissa;
    }
    return k;
}

Token number_token(std::string_view text) {
    Token token{Token::Kind::number, std::string{text}};
    if (text[0] == '+') text.remove_prefix(1);
    std::from_chars(text.data(), text.data() + text.size(), token.value);
    const std::size_t e = std::min(text.find('e'), text.size());
    const std::size_t point = text.substr(0, e).find('.');
    int exponent = 0;
    if (e < text.size()) {
        const std::size_t plus = text[e + 1] == '+' ? 1 : 0;  // from_chars knows no plus sign
        std::from_chars(text.data() + e + 1 + plus, text.data() + text.size(), exponent);
    }
    if (point != std::string_view::npos) exponent -= static_cast<int>(e - point - 1);
    token.unit = std::pow(10.0, exponent);
    return token;
}

std::vector<Token> tokens(std::string_view line) {
    std::vector<Token> list;
    std::string text;
    const auto end_text = [&] {
        if (!text.empty()) list.push_back({Token::Kind::text, text});
        text.clear();
    };
    for (std::size_t k = 0; k < line.size();) {
        const char before = k > 0 ? line[k - 1] : ' ';
        std::size_t length = is_letter(before) || is_digit(before) ? 0 : number_length(line.substr(k));
        // "2D", "3rd": a name, not a number.
        if (length > 0 && k + length < line.size() && is_letter(line[k + length])) length = 0;
        if (length == 0) {
            text += line[k++];
            continue;
        }
        std::string_view words_before{text};
        while (words_before.ends_with(' ')) words_before.remove_suffix(1);
        const bool timed = words_before.ends_with(about);
        end_text();
        if (timed) {
            list.push_back({Token::Kind::timing, std::string{line.substr(k, length)}});
        } else {
            list.push_back(number_token(line.substr(k, length)));
        }
        k += length;
    }
    end_text();
    return list;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    for (std::size_t k = 0; (k = text.find(from, k)) != std::string::npos; k += to.size())
        text.replace(k, from.size(), to);
    return text;
}

/// Lines without what depends on the widths of a table's columns: runs of spaces and of dashes count as one;
/// and without what depends on times: a bound of a timing, or none, is a timing.
std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    std::istringstream stream{replaced(replaced(std::string{text}, "≤ ≈", "≈"), no_run, "≈0")};
    for (std::string line; std::getline(stream, line);) {
        std::string kept;
        for (char c : line) {
            if (c == '\r' || c == '\t') c = ' ';
            const char last = kept.empty() ? ' ' : kept.back();
            if (c == ' ' && last == ' ') continue;
            if (c == '-' && kept.size() > 1 && kept.ends_with("--")) continue;
            kept += c;
        }
        while (kept.ends_with(' ')) kept.pop_back();
        lines.push_back(kept);
    }
    while (!lines.empty() && lines.front().empty()) lines.erase(lines.begin());
    while (!lines.empty() && lines.back().empty()) lines.pop_back();
    return lines;
}

bool equal(const Token& printed, const Token& computed) {
    if (printed.kind != computed.kind) return false;
    if (printed.kind == Token::Kind::timing) return true;
    if (printed.kind == Token::Kind::text) return printed.text == computed.text;
    if (std::abs(printed.value) < rounding_noise && std::abs(computed.value) < rounding_noise) return true;
    // A thousandth more than a unit: the difference of two decimal numbers is itself rounded.
    return std::abs(printed.value - computed.value) <= 1.001 * std::min(printed.unit, computed.unit);
}

void compare(const std::string& printed, const std::string& computed, std::vector<std::string>& differences) {
    const auto a = tokens(printed), b = tokens(computed);
    const bool same_shape =
        std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Token& x, const Token& y) {
            return x.kind == y.kind && (x.kind != Token::Kind::text || x.text == y.text);
        });
    if (!same_shape) {
        differences.push_back("\"" + printed + "\" is printed, \"" + computed + "\" computed");
        return;
    }
    for (std::size_t k = 0; k < a.size(); ++k) {
        if (equal(a[k], b[k])) continue;
        std::string place = printed == a[k].text ? "" : " in \"" + printed + "\"";
        differences.push_back(a[k].text + " is printed, " + b[k].text + " computed" + place);
    }
}

}  // namespace

std::vector<std::string> differences(std::string_view printed, std::string_view computed) {
    const auto a = lines_of(printed), b = lines_of(computed);
    if (a.size() != b.size())
        return {std::to_string(a.size()) + " lines are printed, " + std::to_string(b.size()) + " computed"};
    std::vector<std::string> found;
    for (std::size_t k = 0; k < a.size(); ++k) compare(a[k], b[k], found);
    return found;
}

}  // namespace report::words
