#pragma once
#include <filesystem>

#include "common/report/claims.hpp"
#include "common/report/text.hpp"

/// The numbers of a text and those of a full run. Used by chapter.cpp.
namespace report {

/// The text that a program fills, and the book's, which all chapters share and which may not be there.
struct Text {
    std::filesystem::path own, book;
    std::string number{};  ///< of the chapter, "04"
};

/// Throws app::Error, with each difference on standard error, unless the text shows the blocks' numbers, and
/// the claims of both texts are those that were asserted and hold.
void compare_text(const Text& text, const Blocks& blocks, const Claims& claims);
/// After a run that does not look at the text: says on standard error which claims need a full run, and warns
/// of those that do not hold. With the reader's parameters (`changed` names them) that is what the reader has
/// found out; with the book's it may be a busy machine, where a claim is about times. The test of the text is
/// what judges.
void tell_claims(const Claims& claims, const std::string& changed);
/// Puts the blocks into the text. Throws app::Error where blocks and markers do not fit.
void rewrite_text(const std::filesystem::path& readme, const Blocks& blocks);
/// Puts a chapter's CPU seconds into the book's table, block seconds-FOLDER, if there is a book.
void rewrite_seconds(const std::filesystem::path& book, const std::string& folder, double seconds);

}  // namespace report
