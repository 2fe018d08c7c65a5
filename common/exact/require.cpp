#include "common/exact/require.hpp"

#include <array>
#include <charconv>
#include <stdexcept>
#include <string>

namespace exact {

void require(bool holds, const char* problem, const char* what, double value, const char* range) {
    if (holds) return;
    std::array<char, 32> digits{};  // as few as name the number
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    throw std::domain_error{std::string{problem} + ": " + what + " = " + std::string{digits.data(), end} +
                            " lies outside " + range};
}

}  // namespace exact
