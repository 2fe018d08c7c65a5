#pragma once
#include <string>

/// Numbers as they stand in a figure: the true minus sign (U+2212), powers as markup.
namespace plot {

/// With exactly `decimals` digits after the point; never "-0.0".
std::string number_text(double value, int decimals);
/// The shortest text of at most `digits` significant digits: "0.25", "1000000", "2.5×10^{9}".
std::string short_number(double value, int digits = 12);
/// "10^{−3}"
std::string power_of_ten(int exponent);

}  // namespace plot
