#include "common/exact/require.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace exact {

void require(bool holds, const char* problem, const char* what, double value, const char* range) {
    if (holds) return;
    std::array<char, 200> text{};
    for (const int digits : {15, 17}) {  // 0.6, and not 0.59999999999999998; all where they are needed
        std::snprintf(text.data(), text.size(), "%.*g", digits, value);
        if (std::strtod(text.data(), nullptr) == value) break;
    }
    throw std::domain_error{std::string{problem} + ": " + what + " = " + text.data() + " lies outside " +
                            range};
}

}  // namespace exact
