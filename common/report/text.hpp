#pragma once
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace report {

/// `value` with `digits` (1..17) significant digits, in the shorter of "0.0123" and "1.23e-2" (the former if
/// they are equally long); in the latter too if the former would need zeros that are not significant
/// ("1.2e4"), unless `value` is just that whole number, below a million ("12000"). Zero is "0", what is not
/// finite "nan", "inf" or "-inf".
std::string number(double value, int digits);
/// `value` with `decimals` (0..15) digits after the point; never "-0.0".
std::string fixed(double value, int decimals);
/// 100 times the value, with two digits: "0.46".
std::string percent(double value);
/// "< 1e-9": the power of ten above |value|. A drift of rounding has no digits that another compiler would
/// repeat.
std::string below(double value);
/// A measured time or speed: "≈" and the number. Filled into texts, never compared: it differs from run to
/// run. From 1 to a million in plain digits: "≈2.4", "≈240", "≈15000".
std::string timing(double value, int digits = 2);

/// In the place of a cost: no run of a contestant has so small an error; none takes so little time on this
/// machine, which like a time is never compared.
inline constexpr const char *never_reached = "not reached", *no_run = "≈ no run";

/// A row of a CSV file, "1,2.5\n": every digit of the doubles.
std::string csv_row(const std::vector<double>& values);
/// Columns of one length under their names, as a CSV file.
using NamedColumns = std::vector<std::pair<std::string, std::span<const double>>>;
std::string csv(const NamedColumns& columns);

/// A table, printed as GitHub Markdown; numbers are right-aligned.
class Table {
  public:
    explicit Table(std::vector<std::string> header);
    void row(std::vector<std::string> cells);  ///< throws std::invalid_argument unless one cell a column
    std::string markdown() const;

  private:
    std::vector<std::string> header_;
    std::vector<std::vector<std::string>> rows_;
};

/// Texts that a program produces, by name; a README holds each between `<!-- fill NAME -->` and `<!-- end
/// -->` (on lines of their own for tables, or inside a sentence for a number). NAME has no spaces.
using Blocks = std::map<std::string, std::string>;

/// `markdown` with every marked block replaced. A text with newlines stands on lines of its own.
/// Throws std::invalid_argument for a marker without end, a marked name that is not in `blocks`, or a block
/// of `blocks` that the text never shows.
std::string fill(const std::string& markdown, const Blocks& blocks);
/// The same for some of the blocks: what is not in `blocks` stays as it is.
std::string refill(const std::string& markdown, const Blocks& blocks);

/// Differences between the marked blocks of `markdown` and `blocks`, one line each. Words must be equal;
/// a number may differ by one unit of the last digit that both print (rounding on another machine); numbers
/// below 1e-13 are nothing but rounding and count as equal; numbers after "≈" are timings and are not
/// compared. Digits that belong to a word (l1_rho, 2D) are part of it. How wide a table's columns are does
/// not matter.
std::vector<std::string> differences(const std::string& markdown, const Blocks& blocks);

}  // namespace report
