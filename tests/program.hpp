#pragma once
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

/// A chapter's program (CHAPTER_PROGRAM) as a reader calls it.
namespace program {

namespace fs = std::filesystem;

struct Outcome {
    int status = -1;
    std::string text;  // standard output and standard error
};

/// Runs the chapter's program through the shell; `before` may set variables.
inline Outcome run(const std::string& arguments, const std::string& before = "") {
    const std::string command = before + " '" + CHAPTER_PROGRAM + "' " + arguments + " 2>&1";
    Outcome outcome;
    FILE* pipe = popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::array<char, 4096> buffer{};
    for (std::size_t n = 0; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
        outcome.text.append(buffer.data(), n);
    }
    outcome.status = WEXITSTATUS(pclose(pipe));
    return outcome;
}

/// An empty folder, removed at the end.
struct Folder {
    fs::path path = fs::temp_directory_path() / ("sph_chapter_" + std::to_string(getpid()));
    Folder() {
        fs::remove_all(path);
        fs::create_directories(path);
    }
    ~Folder() { fs::remove_all(path); }
    std::size_t files() const {
        std::size_t count = 0;
        for (const auto& entry : fs::recursive_directory_iterator{path}) count += entry.is_regular_file();
        return count;
    }
};

inline std::string read(const fs::path& path) {
    std::ifstream stream{path, std::ios::binary};
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// A CSV without its parameters, the lines "# name=value" above its header.
inline std::string table(const fs::path& path) {
    std::istringstream text{read(path)};
    std::string rows;
    for (std::string line; std::getline(text, line);) {
        if (line.rfind("# ", 0) != 0) rows += line + "\n";
    }
    return rows;
}

inline std::size_t lines(const std::string& text) {
    return std::size_t(std::count(text.begin(), text.end(), '\n'));
}

inline void check_refused(const std::string& arguments, int status, const std::string& named,
                          const std::string& before = "") {
    INFO(before << " program " << arguments);
    const Outcome outcome = run(arguments, before);
    INFO(outcome.text);
    CHECK(outcome.status == status);
    // One line, after warnings and what a slow machine tells of its progress.
    std::istringstream text{outcome.text};
    std::string line;
    while (std::getline(text, line) && (line.rfind("warning: ", 0) == 0 || line.rfind("chapter ", 0) == 0)) {}
    CHECK(text.peek() == std::istringstream::traits_type::eof());
    CHECK(line.rfind("error: ", 0) == 0);
    CHECK(line.find(named) != std::string::npos);
}

}  // namespace program
