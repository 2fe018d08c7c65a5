#include "common/report/entry.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace report {

std::string Entry::options(std::vector<std::string>* names) const {
    app::CommandLine line{"", ""};
    if (task.declare) task.declare(line);
    if (names) *names = line.names();
    return line.entries();
}

bool Entry::takes(const std::string& option) const {
    std::vector<std::string> names;
    options(&names);
    return std::find(names.begin(), names.end(), option) != names.end();
}

std::vector<std::string> names_of(const std::vector<Entry>& entries) {
    std::vector<std::string> names;
    for (const auto& entry : entries) names.push_back(entry.name);
    return names;
}

const Entry* find(const std::vector<Entry>& entries, const std::string& name) {
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.name == name; });
    return found == entries.end() ? nullptr : &*found;
}

std::string listed(const std::string& title, const std::vector<Entry>& entries) {
    if (entries.empty()) return "";
    std::size_t width = 0;
    for (const auto& entry : entries) width = std::max(width, entry.name.size());
    std::string text = title + ":\n";
    for (const auto& entry : entries)
        text += fmt::format("  {:<{}}  {}\n", entry.name, width, entry.description);
    return text;
}

std::string options_of(const std::vector<Entry>& entries, const std::string& choice) {
    std::vector<std::pair<std::string, std::string>> takers;  // their options and their names
    for (const Entry& entry : entries) {
        const std::string options = entry.options();
        if (options.empty()) continue;
        const auto same = std::find_if(takers.begin(), takers.end(),
                                       [&](const auto& known) { return known.first == options; });
        if (same == takers.end()) {
            takers.emplace_back(options, entry.name);
        } else {
            same->second += ", " + entry.name;
        }
    }
    std::string text;
    for (const auto& [options, names] : takers)
        text += "\nOptions of " + choice + " " + names + ":\n" + options;
    return text;
}

Place Place::of_chapter(const std::string& folder) {
    const bool numbered = folder.size() > 3 && std::all_of(folder.begin(), folder.begin() + 2,
                                                           [](char c) { return c >= '0' && c <= '9'; });
    if (!numbered) throw std::invalid_argument{"a chapter's folder is named as 01_name: " + folder};
    const std::string number = folder.substr(0, 2);
    return {folder, "./tutorial run " + number, fmt::format("chapter {}", std::stoi(number)),
            std::filesystem::path{"chapters"} / folder / "README.md", number};
}

}  // namespace report
