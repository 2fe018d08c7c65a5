#include "common/report/text.hpp"

#include <fmt/format.h>
#include <array>
#include <cstdio>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "common/report/words.hpp"

namespace report {
namespace {

constexpr std::string_view begin_mark = "<!-- fill ", close_mark = " -->", end_mark = "<!-- end -->";

/// A marked block of a text: what stands between its markers is [begin, end).
struct Marked {
    std::string name;
    std::size_t begin, end;
};

std::vector<Marked> find_marked(std::string_view markdown) {
    std::vector<Marked> found;
    std::size_t position = 0;
    while ((position = markdown.find(begin_mark, position)) != std::string_view::npos) {
        const std::size_t name_begin = position + begin_mark.size();
        const std::size_t name_end = markdown.find(close_mark, name_begin);
        const std::string name{markdown.substr(name_begin, name_end - name_begin)};
        if (name_end == std::string_view::npos || name.empty() ||
            name.find_first_of(" \n") != std::string::npos)
            throw std::invalid_argument{"a fill marker without a name: <!-- fill NAME --> is needed"};
        const std::size_t begin = name_end + close_mark.size();
        const std::size_t end = markdown.find(end_mark, begin);
        if (end == std::string_view::npos || markdown.find(begin_mark, begin) < end)
            throw std::invalid_argument{"<!-- fill " + name + " --> has no <!-- end -->"};
        found.push_back({name, begin, end});
        position = end + end_mark.size();
    }
    return found;
}

/// Names in `blocks` that no marker of the text bears.
std::vector<std::string> not_shown(const std::vector<Marked>& marked, const Blocks& blocks) {
    std::set<std::string> shown;
    for (const auto& block : marked) shown.insert(block.name);
    std::vector<std::string> names;
    for (const auto& [name, text] : blocks)
        if (!shown.contains(name)) names.push_back(name);
    return names;
}

/// A text with newlines stands on lines of its own.
std::string as_filled(std::string text) {
    if (text.find('\n') == std::string::npos) return text;
    if (text.front() != '\n') text.insert(0, 1, '\n');
    if (text.back() != '\n') text += '\n';
    return text;
}

}  // namespace

std::string number(double value, int digits) {
    if (digits < 1 || digits > 17) throw std::invalid_argument{"number: digits must be in 1..17"};
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    if (value == 0) return "0";
    std::string scientific = fmt::format("{:.{}e}", value, digits - 1);
    const std::size_t e = scientific.find('e');
    const int exponent = std::stoi(scientific.substr(e + 1));  // after rounding: 9.99 is 10 to two digits
    scientific = fmt::format("{}e{}", scientific.substr(0, e), exponent);
    std::string fixed = fmt::format("{:.{}f}", value, std::max(0, digits - 1 - exponent));
    if (exponent < 0) return fixed.size() <= scientific.size() ? fixed : scientific;
    if (exponent < digits) return fixed;
    // More digits than are significant would be zeros that look measured, unless they are exact.
    return exponent < 6 && std::stod(scientific) == value ? fixed : scientific;
}

std::string fixed(double value, int decimals) {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    const bool zero = text.find_first_of("123456789") == std::string::npos;
    return zero && text.front() == '-' ? text.substr(1) : text;
}

std::string percent(double value) {
    return number(100 * value, 2);
}

std::string below(double value) {
    return "< 1e" + std::to_string(static_cast<int>(std::ceil(std::log10(std::max(std::abs(value), 1e-15)))));
}

std::string csv_row(const std::vector<double>& values) {
    std::string row;
    for (const double value : values) {
        std::array<char, 32> text{};
        const int length = std::snprintf(text.data(), text.size(), "%.17g", value);
        if (!row.empty()) row += ',';
        row.append(text.data(), static_cast<std::size_t>(length));
    }
    return row + '\n';
}

std::string csv(const NamedColumns& columns) {
    std::string text;
    for (const auto& [name, column] : columns) text += (text.empty() ? "" : ",") + name;
    text += '\n';
    const std::size_t rows = columns.empty() ? 0 : columns.front().second.size();
    for (std::size_t i = 0; i < rows; ++i) {
        std::vector<double> row;
        for (const auto& [name, column] : columns) row.push_back(column[i]);
        text += csv_row(row);
    }
    return text;
}

std::string timing(double value, int digits) {
    if (!(value >= 1 && value < 1e6)) return "≈" + number(value, digits);
    const double unit = std::pow(10, std::floor(std::log10(value)) + 1 - digits);
    const double rounded = unit * std::round(value / unit);
    return "≈" +
           fmt::format("{:.{}f}", rounded, unit < 1 ? static_cast<int>(std::round(-std::log10(unit))) : 0);
}

std::string refill(const std::string& markdown, const Blocks& blocks) {
    std::string filled;
    std::size_t position = 0;
    for (const auto& block : find_marked(markdown)) {
        const auto found = blocks.find(block.name);
        if (found == blocks.end()) continue;
        if (found->second.find("<!--") != std::string::npos)
            throw std::invalid_argument{"the text for <!-- fill " + block.name +
                                        " --> holds a comment itself"};
        filled.append(markdown, position, block.begin - position);
        filled += as_filled(found->second);
        position = block.end;
    }
    return filled.append(markdown, position);
}

std::string fill(const std::string& markdown, const Blocks& blocks) {
    const auto marked = find_marked(markdown);
    if (const auto missing = not_shown(marked, blocks); !missing.empty())
        throw std::invalid_argument{"the text has no <!-- fill " + missing.front() + " -->"};
    for (const auto& block : marked) {
        if (!blocks.contains(block.name))
            throw std::invalid_argument{"nothing to put between <!-- fill " + block.name +
                                        " --> and its end"};
    }
    return refill(markdown, blocks);
}

std::vector<std::string> differences(const std::string& markdown, const Blocks& blocks) {
    std::vector<std::string> lines;
    std::vector<Marked> marked;
    try {
        marked = find_marked(markdown);
    } catch (const std::invalid_argument& error) {
        return {error.what()};
    }
    for (const auto& block : marked) {
        const auto found = blocks.find(block.name);
        if (found == blocks.end()) {
            lines.push_back(block.name + ": stands in the text, but is not computed");
            continue;
        }
        for (const auto& difference :
             words::differences(markdown.substr(block.begin, block.end - block.begin), found->second))
            lines.push_back(block.name + ": " + difference);
    }
    for (const auto& name : not_shown(marked, blocks))
        lines.push_back(name + ": is computed, but does not stand in the text");
    return lines;
}

}  // namespace report
