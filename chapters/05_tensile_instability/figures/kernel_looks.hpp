#pragma once
#include <algorithm>
#include <string>

#include "common/plot/looks.hpp"

namespace sph::tensile {

/// One kernel, one colour and marker in this chapter's figures.
inline plot::Style look_of_kernel(const std::string& kernel, std::string label = "") {
    using plot::Marker;
    static const std::vector<std::pair<std::string, Marker>> looks{{"cubic", Marker::square},
                                                                   {"quintic", Marker::diamond},
                                                                   {"wendland-c2", Marker::circle},
                                                                   {"wendland-c4", Marker::triangle_up},
                                                                   {"wendland-c6", Marker::triangle_down}};
    std::size_t index = 0;
    while (index + 1 < looks.size() && looks[index].first != kernel) ++index;
    return {.label = std::move(label), .colour = plot::cycle(index), .marker = looks[index].second};
}

}  // namespace sph::tensile
