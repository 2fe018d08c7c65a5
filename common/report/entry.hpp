#pragma once
#include <string>
#include <vector>

#include "common/report/chapter.hpp"

/// The figures and scenes of a chapter's program by name. Used by chapter.cpp.
namespace report {

/// A figure of the book or a scene of the reader's own.
struct Entry {
    std::string name, description;
    Task task;
    bool timed = false;

    /// Its options as --help prints them, and their names.
    std::string options(std::vector<std::string>* names = nullptr) const;
    bool takes(const std::string& option) const;
};

std::vector<std::string> names_of(const std::vector<Entry>& entries);
/// The one of that name; nullptr if there is none.
const Entry* find(const std::vector<Entry>& entries, const std::string& name);
/// Names and descriptions under a title; nothing if there are none.
std::string listed(const std::string& title, const std::vector<Entry>& entries);
/// The options of figures or scenes, those that take the same together.
std::string options_of(const std::vector<Entry>& entries, const std::string& choice);

}  // namespace report
