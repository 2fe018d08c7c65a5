// Runs the commands of a chapter's exercises: run_exercises README PROGRAMS. Exit status: 0 all of them end
// as the text says, 1 not.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "tests/lesson/rules/exercises.hpp"
#include "tests/lesson/rules/shell.hpp"

namespace {

int run(const std::filesystem::path& readme, const std::filesystem::path& programs) {
    const std::string text = lesson::read_file(readme);
    const auto failures = lesson::failures(text, programs);
    for (const std::string& failure : failures) std::puts(failure.c_str());
    if (lesson::commands_of(text).empty()) std::puts("the text has no exercise with a command");
    return failures.empty() && !lesson::commands_of(text).empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc == 3) return run(argv[1], argv[2]);
        std::puts("usage: run_exercises README PROGRAMS");
    } catch (const std::exception& error) {
        std::puts(error.what());
    }
    return 1;
}
