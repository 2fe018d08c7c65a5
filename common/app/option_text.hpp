#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "common/app/command_line.hpp"

/// The words of options: values as they are typed and as they are shown. Used by command_line.cpp.
namespace app::option_text {

/// A finite number within `range`. Throws UsageError that begins with `option` ("--h-over-dx").
double parse_number(const std::string& option, std::string_view word, const Range& range);
long parse_integer(const std::string& option, std::string_view word, long low, long high);
/// Comma-separated numbers, at least one, exactly `count` if that is positive.
std::vector<double> parse_numbers(const std::string& option, std::string_view word, const Range& range,
                                  std::size_t count);
/// One of `allowed`; the message names the nearest.
std::string parse_choice(const std::string& option, const std::string& word,
                         const std::vector<std::string>& allowed);

/// "1..256", ">= 0"
std::string range_text(long low, long high);

/// The shortest text that reads back as the same value.
std::string shown(double value);
std::string shown(long value);
std::string shown(const std::vector<double>& values);
/// As one word of a shell's command line, quoted if need be.
std::string quoted(const std::string& word);

/// "a, b, c"
std::string joined(const std::vector<std::string>& words);

/// "meaning [unit]; range; default value", without the parts that are empty.
std::string described(std::string_view meaning, std::string_view unit, const std::string& range,
                      const std::string& default_value);

/// A long option with one dash, "-h-over-dx", which CLI11 would read as -h and whatever follows. Not
/// "-1,0,1", "-inf" or "-h".
bool has_one_dash(const std::string& word);
/// What is said about a word that is no option or command; it names the nearest known one.
std::string unknown(const std::string& word, const std::vector<std::string>& known, bool is_option,
                    bool has_commands);

/// `left` in a column, `right` beside it, wrapped: an entry of --help.
std::string entry(const std::string& left, const std::string& right);

}  // namespace app::option_text
