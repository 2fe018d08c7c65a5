#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "common/report/text.hpp"

namespace report {
namespace {

std::size_t letters(std::string_view utf8) {
    return static_cast<std::size_t>(
        std::count_if(utf8.begin(), utf8.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// A bar would begin the next cell, a newline the next row. What labels of figures write $x$ is $`x`$ in
/// texts.
std::string escaped(const std::string& cell) {
    std::string text;
    bool formula = false;
    for (std::size_t k = 0; k < cell.size(); ++k) {
        const bool dollar = cell[k] == '$' && cell.find('`') == std::string::npos;
        if (cell[k] == '|' && (k == 0 || cell[k - 1] != '\\')) text += '\\';
        if (dollar && formula) text += '`';
        text += cell[k] == '\n' ? ' ' : cell[k];
        if (dollar && !formula) text += '`';
        if (dollar) formula = !formula;
    }
    return text;
}

/// "12", "-1.5e-3", "≈0.2", "≤ ≈0.2": what a reader compares by its digits.
bool is_number(std::string_view cell) {
    for (const std::string_view bound : {"≤ ", "≥ "})
        if (cell.starts_with(bound)) cell.remove_prefix(bound.size());
    if (cell.starts_with("≈")) return true;
    if (cell.starts_with('-') || cell.starts_with('+')) cell.remove_prefix(1);
    return !cell.empty() && cell[0] >= '0' && cell[0] <= '9' &&
           cell.find_first_not_of("0123456789.e+-") == std::string_view::npos;
}

/// In the place of a number that there is not.
bool is_gap(std::string_view cell) {
    return cell.empty() || cell == "-" || cell == "–" || cell == never_reached;
}

std::string padded(const std::string& cell, std::size_t width, bool right) {
    const std::string space(width - letters(cell), ' ');
    return right ? space + cell : cell + space;
}

}  // namespace

Table::Table(std::vector<std::string> names) : header_{std::move(names)} {
    if (header_.empty()) throw std::invalid_argument{"table: no columns"};
    for (auto& cell : header_) cell = escaped(cell);
}

void Table::row(std::vector<std::string> cells) {
    if (cells.size() != header_.size()) throw std::invalid_argument{"table: a row needs one cell a column"};
    for (auto& cell : cells) cell = escaped(cell);
    rows_.push_back(std::move(cells));
}

std::string Table::markdown() const {
    const std::size_t columns = header_.size();
    std::vector<std::size_t> width(columns);
    std::vector<bool> right(columns);
    for (std::size_t c = 0; c < columns; ++c) {
        width[c] = std::max<std::size_t>(letters(header_[c]), 3);
        std::size_t numbers = 0, texts = 0;
        for (const auto& row : rows_) {
            width[c] = std::max(width[c], letters(row[c]));
            if (!is_gap(row[c])) ++(is_number(row[c]) ? numbers : texts);
        }
        right[c] = numbers > 0 && texts == 0;
    }
    const auto line = [&](const std::vector<std::string>& cells) {
        std::string text = "|";
        for (std::size_t c = 0; c < columns; ++c)
            text.append(" ").append(padded(cells[c], width[c], right[c])).append(" |");
        return text + '\n';
    };
    std::string text = line(header_) + '|';
    for (std::size_t c = 0; c < columns; ++c)
        text += ' ' + std::string(width[c] - (right[c] ? 1 : 0), '-') + (right[c] ? ": |" : " |");
    text += '\n';
    for (const auto& row : rows_) text += line(row);
    return text;
}

}  // namespace report
