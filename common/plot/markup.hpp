#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace plot {

/// A stretch of text in one style, with what hangs on its end below and above (each may be empty).
struct TextRun {
    std::u32string text;
    bool italic = false;
    std::vector<TextRun> below, above;
    bool operator==(const TextRun&) const = default;
};

/// UTF-8 as code points. Bytes that are not UTF-8 become U+FFFD, control characters (line breaks too) a
/// space.
std::u32string decode_utf8(std::string_view text);

/// Markup as spans: `_{..}` and `^{..}` hang their content on what stands before (both may hang on the same
/// place, and nest up to 3 deep), letters within `$..$` are italic, digits and signs there are not.
/// Whatever has no partner (a single `$`, `_{` without `}`) or no brace (`file_name`) is text.
std::vector<TextRun> parse_markup(std::string_view text);

}  // namespace plot
