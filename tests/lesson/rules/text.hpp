#pragma once
#include <span>
#include <string>
#include <utility>
#include <vector>

/// The form of a chapter's text, which CONTRIBUTING.md describes.
namespace lesson {

enum class Kind { heading, paragraph, image, table, fence };

/// A part of a Markdown text, as far as the rules of a lesson need to tell parts apart. An item of a list is
/// a paragraph of its own; so is what stands in a quote, without its ">".
struct Block {
    Kind kind = Kind::paragraph;
    int line = 0;  // of its first line, from 1
    std::string text =
        "";         // a heading's title; the lines inside a fence; otherwise its lines without comments
    int level = 0;  // of a heading
    std::string info = "";     // of a fence: what stands behind its backticks
    std::string marker = "";   // of a fence: the line before it
    bool opens_quote = false;  // it is the first of a quote
};

std::vector<Block> blocks_of(const std::string& markdown);

/// A heading and what follows until the next one of its level or above.
struct Section {
    std::string title;
    int line = 0;
    std::span<const Block> blocks;  // without the heading
};
std::vector<Section> sections_of(std::span<const Block> blocks, int level);
/// What stands before the first section of level 2.
std::span<const Block> opening_of(std::span<const Block> blocks);

/// What stands inside lines: code and formulas apart from words.
struct Inline {
    std::string words;                                  // blanks for code and formulas; line breaks stay
    std::vector<std::string> codes;                     // `...`
    std::vector<std::pair<int, std::string>> formulas;  // $`...`$, with the line, from 0
    std::vector<int> dollars;                           // the lines of dollars that belong to no formula
};
Inline inside(const std::string& text);

/// Runs of blanks and line breaks as one blank, none at the ends.
std::string in_one_line(const std::string& text);
bool starts_with(const std::string& text, const std::string& prefix);
bool contains(const std::string& text, const std::string& part);
int count_lines(const std::string& text);
/// "- ", "* " or "12. " at its beginning.
bool begins_item(const std::string& text);

}  // namespace lesson
