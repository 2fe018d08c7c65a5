#include "common/report/comparison.hpp"

#include <cmath>
#include <stdexcept>

namespace report {
namespace {

std::vector<std::string> header_of(std::vector<std::string> labels, const std::vector<Shows>& columns) {
    for (const Shows& column : columns) labels.push_back(column.title);
    return labels;
}

const Quantity* find(const Quantities& measured, const std::string& name) {
    for (const Quantity& one : measured) {
        if (one.name == name) return &one;
    }
    return nullptr;
}

}  // namespace

Shown digits(int count, double factor) {
    return [=](double value) { return number(factor * value, count); };
}
Shown decimals(int count, double factor) {
    return [=](double value) { return fixed(factor * value, count); };
}
Shown time_in(double unit) {
    return [=](double value) { return timing(value / unit); };
}
Shown in_percent() {
    return percent;
}
Shown whole() {
    return decimals(0);
}
Shown or_word(double least, std::string word, Shown otherwise) {
    return [=](double value) { return std::abs(value) < least ? word : otherwise(value); };
}

Comparison::Comparison(std::vector<std::string> labels, std::vector<Shows> columns)
    : columns_{std::move(columns)},
      width_{labels.size() + columns_.size()},
      table_{header_of(labels, columns_)} {}

void Comparison::add(Run& run, const std::string& name, std::size_t n, std::vector<std::string> labels,
                     const Quantities& measured, Digits shown) {
    run.record(name, n, measured);
    show(std::move(labels), measured, shown);
}

void Comparison::show(std::vector<std::string> labels, const Quantities& measured, Digits shown) {
    for (const Shows& column : columns_) {
        if (!column.otherwise.empty() && !find(measured, column.quantity)) {
            labels.push_back(column.otherwise);
            continue;
        }
        const std::string text = column.text(value_of(measured, column.quantity));
        const bool mark = shown == Digits::noisy && text.find_first_of("0123456789") == 0;
        labels.push_back((mark ? "≈" : "") + text);
    }
    table_.row(std::move(labels));
}

void Comparison::add_words(std::vector<std::string> cells) {
    cells.resize(width_);
    table_.row(std::move(cells));
}

double value_of(const Quantities& measured, const std::string& name) {
    if (const Quantity* found = find(measured, name)) return found->value;
    throw std::out_of_range{"not measured: " + name};
}

Quantities operator+(Quantities a, const Quantities& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

}  // namespace report
