#pragma once
#include "common/plot/text_box.hpp"

/// Text without a font: every character 0.6 em wide, sub- and superscripts 0.42 em, markup nothing.
inline plot::TextSize plain_measure(std::string_view text, double size) {
    double width = 0, ascent = 0.76, script = 1;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '{') script = 0.7;
        if (c == '}') script = 1;
        if (c == '^') ascent = 1.0;
        const bool is_markup = c == '{' || c == '}' || c == '_' || c == '^' || c == '$';
        const bool continues = (byte & 0xC0U) == 0x80U;  // a later byte of a UTF-8 character
        if (!is_markup && !continues) width += 0.6 * script;
    }
    return {width * size, ascent * size, 0.24 * size};
}
