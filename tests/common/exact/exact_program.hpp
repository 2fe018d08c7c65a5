#pragma once
#include <sys/wait.h>

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

}  // namespace exact_program
