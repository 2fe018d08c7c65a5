#include "common/report/chapter_text.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "common/app/error.hpp"
#include "common/app/files.hpp"

namespace report {

void compare_text(const Text& text, const Blocks& blocks, const Claims& claims) {
    const std::filesystem::path& readme = text.own;
    const std::string own = app::read_file(readme);
    auto found = differences(own, blocks);
    try {
        const std::string book = std::filesystem::exists(text.book) ? app::read_file(text.book) : "";
        const auto broken = broken_claims(own, book, text.number, claims);
        found.insert(found.end(), broken.begin(), broken.end());
    } catch (const std::invalid_argument& error) {
        found.emplace_back(error.what());
    }
    for (const auto& line : found) fmt::print(stderr, "{}\n", line);
    if (!found.empty())
        throw app::Error{app::ExitCode::failed,
                         fmt::format("{}: {} {}", readme.string(), found.size(),
                                     found.size() == 1 ? "difference" : "differences")};
}

void tell_claims(const Claims& claims, const std::string& changed) {
    const std::string skipped = names_with(Verdict::skipped, claims);
    const std::string failing = names_with(Verdict::fails, claims);
    if (!skipped.empty()) fmt::print(stderr, "claims that need a full run: {}\n", skipped);
    if (!failing.empty())
        fmt::print(stderr, "warning: claims of the text that do not hold {}: {}\n",
                   changed.empty() ? "in this run (those about times: on this machine)" : "with " + changed,
                   failing);
}

void rewrite_text(const std::filesystem::path& readme, const Blocks& blocks) {
    try {
        app::write_file(readme, fill(app::read_file(readme), blocks));
    } catch (const std::invalid_argument& error) {
        throw app::Error{app::ExitCode::failed, readme.string() + ": " + error.what()};
    }
}

void rewrite_seconds(const std::filesystem::path& book, const std::string& folder, double seconds) {
    if (!std::filesystem::exists(book)) return;
    app::write_file(book, refill(app::read_file(book), {{"seconds-" + folder, timing(seconds) + " s"}}));
}

}  // namespace report
