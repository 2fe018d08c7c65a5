#include "common/report/chapter_text.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "common/app/error.hpp"
#include "common/app/files.hpp"

namespace report {

void compare_text(const std::filesystem::path& readme, const Blocks& blocks) {
    const auto found = differences(app::read_file(readme), blocks);
    for (const auto& line : found) fmt::print(stderr, "{}\n", line);
    if (!found.empty())
        throw app::Error{app::ExitCode::failed,
                         fmt::format("{}: {} {}", readme.string(), found.size(),
                                     found.size() == 1 ? "difference" : "differences")};
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
