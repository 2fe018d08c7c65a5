#pragma once
#include <functional>
#include <string>
#include <vector>

#include "common/report/chapter.hpp"

/// Runs side by side: what each measured goes to results.csv, and a table shows part of it.
namespace report {

/// How a table shows a measured number.
using Shown = std::function<std::string(double)>;
Shown digits(int count, double factor = 1);    ///< report::number(factor * value, count)
Shown decimals(int count, double factor = 1);  ///< report::fixed
Shown time_in(double unit);                    ///< report::timing(value / unit): 1e-3 for milliseconds
Shown in_percent();                            ///< report::percent
Shown whole();                                 ///< "1638"
/// Smaller than `least`: the word; nothing but rounding has digits that another compiler would repeat.
Shown or_word(double least, std::string word, Shown otherwise);

/// A column of a table: the quantity of that name.
struct Shows {
    std::string title, quantity;
    Shown text;
    std::string otherwise{};  ///< where a run has not measured it; empty: every run must have
};

/// Whether another machine would print the same digits. Those of a run that amplifies rounding are marked
/// with "≈", as times are, and not compared.
enum class Digits { stable, noisy };

class Comparison {
  public:
    /// `labels`: titles of the columns that a row begins with.
    Comparison(std::vector<std::string> labels, std::vector<Shows> columns);
    /// A run of `name` with n particles: its rows of results.csv, and a row of the table.
    void add(Run& run, const std::string& name, std::size_t n, std::vector<std::string> labels,
             const Quantities& measured, Digits shown = Digits::stable);
    /// The row of the table alone. Both throw std::out_of_range for a quantity that was not measured.
    void show(std::vector<std::string> labels, const Quantities& measured, Digits shown = Digits::stable);
    /// A row of words, from the left.
    void add_words(std::vector<std::string> cells);
    std::string markdown() const { return table_.markdown(); }

  private:
    std::vector<Shows> columns_;
    std::size_t width_;
    Table table_;
};

/// The value of that name. Throws std::out_of_range if it was not measured.
double value_of(const Quantities& measured, const std::string& name);
/// Both, the first ones first.
Quantities operator+(Quantities a, const Quantities& b);

}  // namespace report
