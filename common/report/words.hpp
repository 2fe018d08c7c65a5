#pragma once
#include <string>
#include <string_view>
#include <vector>

/// Comparison of a printed text with a computed one, word by word. Used by text.cpp.
namespace report::words {

/// One line a difference, as described at report::differences.
std::vector<std::string> differences(std::string_view printed, std::string_view computed);

}  // namespace report::words
