#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace sph {

/// Particles begin..end under one name.
struct Group {
    std::string name;
    std::size_t begin = 0, end = 0;
};

/// Which particles forces move. All are free unless a group holds them: held particles are neighbours like
/// all others, but keep what forces would change (columns that say `held`): at rest they are a wall, moving
/// on with their velocity they stand for more of the same gas beyond an end, and a rigid body is moved by its
/// scene, with the sum of the forces that its particles have collected.
class Groups {
  public:
    /// Holds the particles begin..end. Throws std::invalid_argument for an empty or overlapping range or a
    /// name that is taken.
    void hold(std::string name, std::size_t begin, std::size_t end);
    /// Throws std::out_of_range if there is none of that name.
    const Group& named(const std::string& name) const;
    const std::vector<Group>& held() const& noexcept { return held_; }
    void held() && = delete;  // what it refers to would be gone

    /// Calls visit(begin, end) for the ranges of free particles among the first n, in order.
    template <class Visit>
    void for_each_free(std::size_t n, Visit&& visit) const {
        std::size_t begin = 0;
        for (const Group& group : held_) {
            if (begin < group.begin && begin < n) visit(begin, group.begin < n ? group.begin : n);
            begin = group.end;
        }
        if (begin < n) visit(begin, n);
    }
    /// How many of the first n particles are free.
    std::size_t free(std::size_t n) const {
        std::size_t count = 0;
        for_each_free(n, [&](std::size_t begin, std::size_t end) { count += end - begin; });
        return count;
    }

  private:
    std::vector<Group> held_;  // in order
};

}  // namespace sph
