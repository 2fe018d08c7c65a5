#include "tests/lesson/rules/exercises.hpp"

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include "tests/lesson/rules/lesson.hpp"
#include "tests/lesson/rules/shell.hpp"

namespace lesson {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t exercises = 3;

/// Where " #" begins a comment, outside quotes.
std::size_t comment_in(const std::string& line) {
    char quote = 0;
    for (std::size_t k = 0; k < line.size(); ++k) {
        if (quote != 0) {
            if (line[k] == quote) quote = 0;
        } else if (line[k] == '\'' || line[k] == '"') {
            quote = line[k];
        } else if (line[k] == '#' && k > 0 && line[k - 1] == ' ') {
            return k;
        }
    }
    return line.size();
}

Command command_of(int number, const std::string& line) {
    static const std::regex stated{"exits with status ([0-9]{1,3})"};
    const std::size_t end = comment_in(line);
    const std::string comment = line.substr(end, 200);
    std::smatch match;
    const int status = std::regex_search(comment, match, stated) ? std::stoi(match[1]) : 0;
    return {number, in_one_line(line.substr(0, end)), status};
}

/// The lines of a fence with their numbers; what ends with a backslash goes on in the next one.
std::vector<std::pair<int, std::string>> lines_of(const Block& fence) {
    std::vector<std::pair<int, std::string>> found;
    std::istringstream stream{fence.text};
    bool goes_on = false;
    int number = fence.line;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        const bool more = !line.empty() && line.back() == '\\';
        if (more) line.pop_back();
        if (goes_on)
            found.back().second += line;
        else
            found.emplace_back(number, line);
        goes_on = more;
    }
    return found;
}

bool is_command(const std::string& line) {
    return starts_with(in_one_line(line), "./tutorial ");
}
std::vector<Command> commands_in(std::span<const Block> blocks) {
    std::vector<Command> found;
    for (const Block& block : blocks) {
        if (block.kind != Kind::fence) continue;
        for (const auto& [number, line] : lines_of(block)) {
            if (is_command(line)) found.push_back(command_of(number, line));
        }
    }
    return found;
}

std::string words_in(std::span<const Block> blocks) {
    std::string words;
    for (const Block& block : blocks) {
        if (block.kind != Kind::fence) words += inside(block.text).words + " ";
    }
    return in_one_line(words);
}

void check_exercise(const Section& exercise, Breaches& breaches) {
    const auto lacks = [&](const std::string& what) {
        breaches.add(exercise.line, "the exercise \"" + exercise.title + "\" " + what);
    };
    if (commands_in(exercise.blocks).empty()) lacks("has no block of code with a ./tutorial command");
    const std::string words = words_in(exercise.blocks);
    if (!contains(words, "You should see")) lacks("does not say \"You should see\"");
    std::size_t k = 0;
    for (const char* tag : {"<details>", "<summary>", "</summary>", "</details>"})
        k = words.find(tag, std::min(k, words.size()));
    if (k == std::string::npos)
        lacks("has no folded solution <details><summary>...</summary> ... </details>");
    for (const Block& block : exercise.blocks) {
        if (block.kind != Kind::fence) continue;
        for (const auto& [number, line] : lines_of(block)) {
            if (contains(line, "./tutorial") && !is_command(line))
                breaches.add(number, "a command of an exercise begins with ./tutorial");
        }
    }
}

const Section* try_next(const std::vector<Section>& sections) {
    const auto found = std::find_if(sections.begin(), sections.end(),
                                    [](const Section& section) { return section.title == "Try next"; });
    return found == sections.end() ? nullptr : &*found;
}

/// The program of chapter "4" or "04", as ./tutorial finds it.
fs::path chapter_program(const fs::path& programs, const std::string& number) {
    const std::string front = (number.size() == 1 ? "0" : "") + number + "_";
    for (const auto& entry : fs::directory_iterator{programs}) {
        const std::string name = entry.path().filename().string();
        if (starts_with(name, front) && name.size() > front.size() && !name.ends_with("_tests"))
            return entry.path();
    }
    throw std::invalid_argument("no program of chapter " + number + " in " + programs.string());
}

}  // namespace

void check_exercises(const Lesson& lesson, Breaches& breaches) {
    const auto sections = sections_of(lesson.blocks, 2);
    const Section* section = try_next(sections);
    if (section == nullptr) return breaches.add(1, "no section \"## Try next\"");
    const auto parts = sections_of(section->blocks, 3);
    if (parts.size() != exercises)
        breaches.add(section->line, "three exercises, not " + std::to_string(parts.size()));
    for (std::size_t k = 0; k < parts.size(); ++k) {
        if (!starts_with(parts[k].title, std::to_string(k + 1) + ". "))
            breaches.add(parts[k].line, "the title of an exercise is ### " + std::to_string(k + 1) + ". ...");
        check_exercise(parts[k], breaches);
    }
}

std::vector<Command> commands_of(const std::string& markdown) {
    const auto blocks = blocks_of(markdown);
    const auto sections = sections_of(blocks, 2);
    const Section* section = try_next(sections);
    return section == nullptr ? std::vector<Command>{} : commands_in(section->blocks);
}

std::optional<std::string> invocation(const std::string& command, const fs::path& programs,
                                      const fs::path& out) {
    static const std::set<std::string> of_the_clone{"test", "figures", "bench", "doctor"};
    std::istringstream words{command};
    std::string tutorial, name, number, options;
    words >> tutorial >> name;
    if (of_the_clone.count(name) > 0) return std::nullopt;
    const bool run = name == "run";
    if (!run && name != "exact") throw std::invalid_argument("./tutorial knows no command '" + name + "'");
    if (run) words >> number;
    std::getline(words, options);
    const fs::path program = run ? chapter_program(programs, number) : programs / "exact";
    const std::string folder = "--out '" + out.string() + "'";
    static const std::regex given{"--out[ =]('[^']*'|\"[^\"]*\"|[^ ]+)"};
    const bool names_out = std::regex_search(options, given);
    if (names_out) options = std::regex_replace(options, given, folder);
    return "'" + program.string() + "'" + (run && !names_out ? " " + folder : "") + options;
}

namespace {

/// "" if the command exits as the text says.
std::string failure_of(const Command& command, const fs::path& programs, const fs::path& folder, int count) {
    try {
        const auto line = invocation(command.text, programs, folder / std::to_string(count));
        if (!line) return "";
        const Outcome outcome = run_in(folder, *line);
        if (outcome.status == command.status) return "";
        const std::size_t shown = std::min<std::size_t>(outcome.text.size(), 500);  // its end
        return "exit status " + std::to_string(outcome.status) + ", not " + std::to_string(command.status) +
               "\n" + outcome.text.substr(outcome.text.size() - shown);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

}  // namespace

std::vector<std::string> failures(const std::string& markdown, const fs::path& programs) {
    std::vector<std::string> found;
    const TemporaryFolder folder;
    int count = 0;
    for (const Command& command : commands_of(markdown)) {
        const std::string what = failure_of(command, programs, folder.path, ++count);
        if (!what.empty())
            found.push_back("README.md:" + std::to_string(command.line) + ": " + command.text + ": " + what);
    }
    return found;
}

}  // namespace lesson
