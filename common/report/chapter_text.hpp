#pragma once
#include <filesystem>

#include "common/report/text.hpp"

/// The numbers of a text and those of a full run. Used by chapter.cpp.
namespace report {

/// Throws app::Error, with each difference on standard error, unless the text shows the blocks' numbers.
void compare_text(const std::filesystem::path& readme, const Blocks& blocks);
/// Puts the blocks into the text. Throws app::Error where blocks and markers do not fit.
void rewrite_text(const std::filesystem::path& readme, const Blocks& blocks);
/// Puts a chapter's CPU seconds into the book's table, block seconds-FOLDER, if there is a book.
void rewrite_seconds(const std::filesystem::path& book, const std::string& folder, double seconds);

}  // namespace report
