#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lesson {

/// A command line of an exercise.
struct Command {
    int line = 0;
    std::string text;  // "./tutorial run 04 --scene tube", without its comment
    int status = 0;    // what it exits with, as its comment says: "# exits with status 3"
};
/// The lines "./tutorial ..." in the blocks of code of the section "Try next".
std::vector<Command> commands_of(const std::string& markdown);

/// What a shell runs for a command where the programs lie in `programs`; what would be written to --out goes
/// to `out`. Nothing for commands that act on the clone: test, figures, bench, doctor. Throws
/// std::invalid_argument for what ./tutorial does not know.
std::optional<std::string> invocation(const std::string& command, const std::filesystem::path& programs,
                                      const std::filesystem::path& out);

/// Runs the commands of a text and tells which ones exit with another status than the text says.
std::vector<std::string> failures(const std::string& markdown, const std::filesystem::path& programs);

}  // namespace lesson
