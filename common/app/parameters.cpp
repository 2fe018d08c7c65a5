#include "common/app/parameters.hpp"

#include <stdexcept>

#include "common/app/error.hpp"
#include "common/app/option_text.hpp"

namespace app {

void Parameters::add(const Parameter& parameter) {
    if (!has(parameter.name)) list_.push_back(parameter);
}

const Parameter* Parameters::find(std::string_view name) const {
    for (const Parameter& one : list_) {
        if (one.name == name) return &one;
    }
    return nullptr;
}

bool Parameters::has(std::string_view name) const {
    return find(name) != nullptr;
}

double Parameters::value(std::string_view name) const {
    if (const Parameter* one = find(name)) return one->value;
    throw std::out_of_range{"no parameter " + std::string{name}};
}

void Parameters::set(std::string_view name, double value) {
    for (Parameter& one : list_) {
        if (one.name != name) continue;
        if (!one.range.contains(value))
            throw UsageError{"--" + one.name + ": " + option_text::shown(value) +
                             " is not allowed; allowed: " + one.range.text()};
        one.value = value;
        return;
    }
    throw std::out_of_range{"no parameter " + std::string{name}};
}

}  // namespace app
