#include "common/app/option_text.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <sstream>

#include "common/app/error.hpp"

namespace app {

bool Range::contains(double value) const noexcept {
    return std::isfinite(value) && (low_open ? value > low : value >= low) &&
           (high_open ? value < high : value <= high);
}

std::string Range::text() const {
    const std::string from = option_text::shown(low);
    const std::string to = option_text::shown(high);
    if (std::isinf(low) && std::isinf(high)) return "any finite number";
    if (std::isinf(high)) return (low_open ? "> " : ">= ") + from;
    if (std::isinf(low)) return (high_open ? "< " : "<= ") + to;
    if (!low_open && !high_open) return from + ".." + to;
    return (low_open ? "> " : ">= ") + from + " and " + (high_open ? "< " : "<= ") + to;
}

namespace {

/// Number of single-letter insertions, deletions, replacements and swaps of neighbours that turn a into b.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                d[i][j] = i + j;
                continue;
            }
            const std::size_t replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    }
    return d[a.size()][b.size()];
}

}  // namespace

void require_above(const std::string& name, double value, double bound, const std::string& where) {
    if (value > bound) return;
    std::ostringstream limit;
    limit.precision(4);
    limit << bound;
    throw UsageError{"--" + name + ": " + option_text::shown(value) + " is not allowed " + where +
                     "; allowed: above " + limit.str()};
}

std::string nearest(std::string_view word, const std::vector<std::string>& known) {
    constexpr std::size_t longest = 100;  // nothing of ours is that long: no need to compare
    std::string best;
    std::size_t best_distance = longest;
    if (word.size() >= longest) return best;
    for (const auto& candidate : known) {
        const std::size_t distance = edit_distance(word, candidate);
        if (2 * distance <= std::max(word.size(), candidate.size()) && distance < best_distance) {
            best = candidate;
            best_distance = distance;
        }
    }
    return best;
}

namespace option_text {
namespace {

[[noreturn]] void refuse(const std::string& option, std::string_view word, const std::string& problem,
                         const std::string& allowed) {
    throw UsageError{option + ": " + quoted(std::string{word}) + " " + problem + "; allowed: " + allowed};
}

template <class T>
std::from_chars_result read(std::string_view word, T& value) {
    // from_chars knows no plus sign; "+1" is a number to everybody else.
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    auto result = std::from_chars(word.data(), word.data() + word.size(), value);
    if (result.ec == std::errc{} && result.ptr != word.data() + word.size())
        result.ec = std::errc::invalid_argument;  // "1.5x"
    return result;
}

template <class T>
std::string shortest(T value) {
    char buffer[64];
    const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
    std::string text{buffer, result.ptr};
    if (const std::size_t e = text.find('e'); e != std::string::npos) {  // 1e6 and 1e-6, not 1e+06 and 1e-06
        if (text[e + 1] == '+') text.erase(e + 1, 1);
        const std::size_t digits = e + (text[e + 1] == '-' ? 2 : 1);
        text.erase(digits, text.find_first_not_of('0', digits) - digits);
    }
    return text;
}

std::size_t letters(std::string_view utf8) {
    return static_cast<std::size_t>(
        std::count_if(utf8.begin(), utf8.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// A number, or the fraction of two: 5/3.
std::from_chars_result read_fraction(std::string_view word, double& value) {
    const std::size_t slash = word.find('/');
    auto result = read(word.substr(0, slash), value);
    if (slash == std::string_view::npos || result.ec != std::errc{}) return result;
    double below = 1;
    result = read(word.substr(slash + 1), below);
    value /= below;
    return result;
}

}  // namespace

double parse_number(const std::string& option, std::string_view word, const Range& range) {
    double value = 0;
    const auto result = read_fraction(word, value);
    if (result.ec == std::errc::result_out_of_range)
        refuse(option, word, "is too large or too small for a number", range.text());
    if (result.ec != std::errc{}) refuse(option, word, "is not a number", range.text());
    if (!std::isfinite(value)) refuse(option, word, "is not a finite number", range.text());
    if (!range.contains(value)) refuse(option, word, "is not allowed", range.text());
    return value;
}

std::string range_text(long low, long high) {
    return high == std::numeric_limits<long>::max() ? ">= " + shown(low) : shown(low) + ".." + shown(high);
}

long parse_integer(const std::string& option, std::string_view word, long low, long high) {
    const std::string allowed = range_text(low, high);
    long value = 0;
    const auto result = read(word, value);
    if (result.ec == std::errc::invalid_argument) refuse(option, word, "is not a whole number", allowed);
    if (result.ec != std::errc{} || value < low || value > high)
        refuse(option, word, "is not allowed", allowed);
    return value;
}

std::vector<double> parse_numbers(const std::string& option, std::string_view word, const Range& range,
                                  std::size_t count) {
    if (word.empty()) throw UsageError{option + ": the list is empty; values are separated by commas"};
    std::vector<double> values;
    for (std::size_t begin = 0; begin <= word.size();) {
        const std::size_t end = std::min(word.find(',', begin), word.size());
        if (end == begin)
            throw UsageError{option + ": a value is missing between the commas of " +
                             quoted(std::string{word})};
        values.push_back(parse_number(option, word.substr(begin, end - begin), range));
        begin = end + 1;
    }
    if (count > 0 && values.size() != count)
        throw UsageError{option + ": " + quoted(std::string{word}) + " has " + std::to_string(values.size()) +
                         (values.size() == 1 ? " value" : " values") + "; allowed: exactly " +
                         std::to_string(count) + ", separated by commas"};
    return values;
}

std::string parse_choice(const std::string& option, const std::string& word,
                         const std::vector<std::string>& allowed) {
    if (std::find(allowed.begin(), allowed.end(), word) != allowed.end()) return word;
    const std::string near = nearest(word, allowed);
    refuse(option, word, near.empty() ? "is not known" : "is not known, did you mean " + near + "?",
           joined(allowed));
}

std::string shown(double value) {
    return shortest(value);
}
std::string shown(long value) {
    return shortest(value);
}
std::string shown(const std::vector<double>& values) {
    std::string text;
    for (const double value : values) {
        if (!text.empty()) text += ',';
        text += shortest(value);
    }
    return text;
}

std::string quoted(const std::string& word) {
    const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view{"-_.,/+:=@%"}.find(c) != std::string_view::npos;
    });
    if (plain) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string{"'\\''"} : std::string{c};
    return text + "'";
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

std::string described(std::string_view meaning, std::string_view unit, const std::string& range,
                      const std::string& default_value) {
    std::string text{meaning};
    if (!unit.empty()) text += " [" + std::string{unit} + "]";
    if (!range.empty()) text += "; " + range;
    if (!default_value.empty()) text += "; default " + default_value;
    return text;
}

std::string entry(const std::string& left, const std::string& right) {
    constexpr std::size_t column = 28, width = 96;
    std::string text = "  " + left;
    std::size_t position = 2 + letters(left);
    const auto indent_to_column = [&] {
        text += std::string(column - position, ' ');
        position = column;
    };
    const auto new_line = [&] {
        text += '\n';
        position = 0;
        indent_to_column();
    };
    if (position + 2 > column) {
        new_line();
    } else {
        indent_to_column();
    }
    std::istringstream words{right};
    for (std::string word; words >> word;) {
        if (position > column) {
            if (position + 1 + letters(word) > width) {
                new_line();
            } else {
                text += ' ';
                ++position;
            }
        }
        text += word;
        position += letters(word);
    }
    return text + '\n';
}

bool has_one_dash(const std::string& word) {
    const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
    return word.size() > 2 && word[0] == '-' && letter(word[1]) && !word.starts_with("-inf") &&
           !word.starts_with("-nan");
}

std::string unknown(const std::string& word, const std::vector<std::string>& known, bool is_option,
                    bool has_commands) {
    const std::string kind = is_option      ? "unknown option "
                             : has_commands ? "unknown command "
                                            : "unexpected word ";
    const std::string letters = word.substr(std::min(word.find_first_not_of('-'), word.size()));
    const std::string near = nearest(is_option ? letters : word, known);
    if (!near.empty())
        return kind + quoted(word) + "; did you mean " + (is_option ? "--" + near : near) + "?";
    return kind + quoted(word) +
           (is_option || !has_commands ? "; --help lists the options" : "; known: " + joined(known));
}

}  // namespace option_text
}  // namespace app
