#pragma once
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <sstream>
#include <string>

/// Which files are the project's. A clone is also its user's folder, with settings of an editor, notes and
/// builds in it: these are nobody else's business.
namespace structure {

inline std::string output_of(const std::string& command) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe{popen(command.c_str(), "r"), pclose};
    std::string text;
    std::array<char, 4096> part{};
    while (const std::size_t count = pipe ? std::fread(part.data(), 1, part.size(), pipe.get()) : 0)
        text.append(part.data(), count);
    return text;
}

/// The files that git keeps and the folders that they stand in, as paths from the root. Empty where git
/// cannot tell.
inline const std::set<std::string>& tracked() {
    static const std::set<std::string> all = [] {
        std::set<std::string> found;
        std::istringstream lines{
            output_of("git -c safe.directory='*' -C '" SPH_SOURCE_DIR "' ls-files 2>/dev/null")};
        for (std::string line; std::getline(lines, line);) {
            for (std::filesystem::path path{line}; !path.empty(); path = path.parent_path())
                found.insert(path.generic_string());
        }
        return found;
    }();
    return all;
}

/// Whether a file or folder is the project's. `unknown`: the answer where git cannot tell.
inline bool is_ours(const std::filesystem::path& path, bool unknown) {
    if (tracked().empty()) return unknown;
    return tracked().count(std::filesystem::relative(path, SPH_SOURCE_DIR).generic_string()) > 0;
}

}  // namespace structure
