#pragma once
#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

/// An option of a CommandLine. Used by command_line.cpp.
namespace app {

/// One declared option: CLI11 collects its words, `read` turns a word into the target's value.
struct Option {
    std::string name;  // "--particles"
    CLI::Option* words = nullptr;
    bool is_flag = false;
    std::function<void(const std::string&)> read{};
    std::function<std::string()> value{};  // the target's value now, as it would be typed
    std::string default_value{};
    bool foreign = false;  // known, but not taken by this run
    std::string entry{};   // of --help

    /// Whether it is among these names, which are without dashes.
    bool is_one_of(const std::vector<std::string>& names) const {
        return std::find(names.begin(), names.end(), name.substr(2)) != names.end();
    }
};

}  // namespace app
