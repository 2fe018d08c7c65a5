#include "common/plot/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace plot {
namespace {

// "-3" -> "−3", "+9" and "09" -> "9"
std::string with_true_minus(const std::string& text) {
    return text.starts_with('-') ? "\u2212" + text.substr(1) : text;
}

}  // namespace

std::string number_text(double value, int decimals) {
    std::string text = fmt::format("{:.{}f}", value, std::max(decimals, 0));
    const bool is_zero = text.find_first_of("123456789") == std::string::npos;
    if (is_zero && text.starts_with('-')) text.erase(0, 1);
    return with_true_minus(text);
}

std::string short_number(double value, int digits) {
    const std::string text = fmt::format("{:.{}g}", value, digits);
    const auto exponent = text.find('e');
    if (exponent == std::string::npos) return with_true_minus(text);
    const std::string mantissa = text.substr(0, exponent);
    const std::string power = power_of_ten(std::atoi(text.c_str() + exponent + 1));
    if (mantissa == "1" || mantissa == "-1")
        return with_true_minus(mantissa.substr(0, mantissa.size() - 1) + power);
    return with_true_minus(mantissa) + "×" + power;
}

std::string power_of_ten(int exponent) {
    return "10^{" + with_true_minus(std::to_string(exponent)) + "}";
}

}  // namespace plot
