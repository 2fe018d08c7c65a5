#include "common/core/groups.hpp"

#include <algorithm>
#include <stdexcept>

namespace sph {

void Groups::hold(std::string name, std::size_t begin, std::size_t end) {
    if (!(begin < end)) throw std::invalid_argument{"group " + name + ": no particles"};
    for (const Group& other : held_) {
        if (other.name == name) throw std::invalid_argument{"group " + name + ": the name is taken"};
        if (begin < other.end && other.begin < end)
            throw std::invalid_argument{"group " + name + " overlaps group " + other.name};
    }
    held_.push_back({std::move(name), begin, end});
    std::sort(held_.begin(), held_.end(), [](const Group& a, const Group& b) { return a.begin < b.begin; });
}

const Group& Groups::named(const std::string& name) const {
    for (const Group& group : held_) {
        if (group.name == name) return group;
    }
    throw std::out_of_range{"no group " + name};
}

}  // namespace sph
