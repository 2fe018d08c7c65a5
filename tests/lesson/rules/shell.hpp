#pragma once
#include <filesystem>
#include <string>

namespace lesson {

struct Outcome {
    int status = -1;   // of the shell: 128 and more for a signal
    std::string text;  // standard output and standard error
};
/// Runs a command of the shell in a folder.
Outcome run_in(const std::filesystem::path& folder, const std::string& command);

/// An empty folder, removed at the end.
struct TemporaryFolder {
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    std::filesystem::path path;
};

std::string read_file(const std::filesystem::path& path);

}  // namespace lesson
