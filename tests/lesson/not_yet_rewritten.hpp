#pragma once
#include <algorithm>
#include <array>
#include <string_view>

namespace lesson {

/// Chapters whose text is not yet a lesson. The list only shrinks: a chapter on it that breaks no rule fails
/// the tests, and so does one that is not on it and breaks one.
inline constexpr std::array<std::string_view, 0> not_yet_rewritten{};

inline bool is_not_yet_rewritten(std::string_view folder) {
    return std::find(not_yet_rewritten.begin(), not_yet_rewritten.end(), folder) != not_yet_rewritten.end();
}

}  // namespace lesson
