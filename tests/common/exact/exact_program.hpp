#pragma once
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// The program `exact` (EXACT_PROGRAM) as a reader calls it.
namespace exact_program {

struct Run {
    int status;
    std::string text;
};

/// The program with these words; `text` is what it writes to standard output, or what `redirection` lets
/// pass.
inline Run run(const std::string& words, const std::string& redirection = "2>/dev/null") {
    const std::string command = "'" EXACT_PROGRAM "' " + words + " " + redirection;
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) throw std::runtime_error{"cannot run " + command};
    std::string text;
    char part[4096];
    for (std::size_t n; (n = std::fread(part, 1, sizeof part, pipe)) > 0;) text.append(part, n);
    const int status = pclose(pipe);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text};
}

/// Standard error alone.
inline Run errors_of(const std::string& words) {
    return run(words, "2>&1 >/dev/null");
}

inline std::vector<std::string> lines(const std::string& text) {
    std::istringstream stream{text};
    std::vector<std::string> all;
    for (std::string line; std::getline(stream, line);) all.push_back(line);
    return all;
}

/// The numbers of a row "1,2.5,-3".
inline std::vector<double> numbers(const std::string& line) {
    std::vector<double> values;
    const char* place = line.c_str();
    for (;;) {
        char* end = nullptr;
        values.push_back(std::strtod(place, &end));
        if (end == place) throw std::runtime_error{"no row of numbers: " + line};
        if (*end == '\0') return values;
        if (*end != ',') throw std::runtime_error{"no row of numbers: " + line};
        place = end + 1;
    }
}

/// The value of a line "# name=value".
inline double constant(const std::string& line, const std::string& name) {
    CHECK_THAT(line, Catch::StartsWith("# " + name + "="));
    return numbers(line.substr(line.find('=') + 1)).front();
}

/// Words that must be refused: status 2, one line that contains both texts, and nothing on standard output.
struct BadUsage {
    const char* words;
    const char* named;
    const char* also;
};
inline void check_refused(const std::vector<BadUsage>& cases) {
    for (const auto& [words, named, also] : cases) {
        CAPTURE(words);
        const Run errors = errors_of(words);
        CHECK(errors.status == 2);
        CHECK(lines(errors.text).size() == 1);
        CHECK_THAT(errors.text,
                   Catch::StartsWith("error: ") && Catch::Contains(named) && Catch::Contains(also));
        CHECK(run(words).text.empty());
    }
}

}  // namespace exact_program
