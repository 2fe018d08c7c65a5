#include "common/exact/require.hpp"

#include <cstdio>
#include <stdexcept>

namespace exact {

void require(bool holds, const char* problem, const char* what, double value, const char* range) {
    if (holds) return;
    char text[200];
    std::snprintf(text, sizeof text, "%s: %s = %.17g lies outside %s", problem, what, value, range);
    throw std::domain_error{text};
}

}  // namespace exact
