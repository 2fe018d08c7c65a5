#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "common/core/ghost.hpp"

/// What particles see where the domain ends. A boundary adds ghosts: copies of particles at other places,
/// which exist only while neighbours are summed. Their columns are never stored, so they cannot be out of
/// date. (A wall made of held particles is no boundary in this sense: see groups.hpp.)
namespace sph {

/// No boundary: nothing is added, nothing is computed.
struct Free {
    template <int d>
    void wrap(Vector<d>&) const {}
    template <int d>
    void add_ghosts(const Columns<d>&, double, std::vector<Ghost<d>>&) const {}
};

enum class Face { free, periodic, mirror };

/// A box whose faces are free, periodic or mirrors, each axis by itself; right for any length, also for boxes
/// shorter than the reach, which see images of images.
/// A particle exactly on a mirror has its image on top of itself: give it half the volume.
template <int d>
struct Box {
    Vector<d> low{}, high{};
    std::array<std::pair<Face, Face>, static_cast<std::size_t>(d)> faces{};  ///< of the low and the high end

    /// The same kind of face everywhere. `low` < `high` on each axis.
    /// Throws std::invalid_argument for an empty box, or an axis that is periodic at one end only.
    Box(const Vector<d>& low_corner, const Vector<d>& high_corner, Face everywhere);
    Box(const Vector<d>& low_corner, const Vector<d>& high_corner,
        std::array<std::pair<Face, Face>, static_cast<std::size_t>(d)> each);

    /// Brings a position that left through a periodic face back into the box.
    void wrap(Vector<d>& x) const {
        for (std::size_t a = 0; a < d; ++a) {
            if (faces[a].first != Face::periodic || (x[a] >= low[a] && x[a] <= high[a])) continue;
            const double length = high[a] - low[a];
            x[a] -= length * std::floor((x[a] - low[a]) / length);
        }
    }
    /// All images within `reach` of the box, of the points x, which lie in it.
    /// Cost: the points, and the images on each axis.
    void add_ghosts(const Columns<d>& x, double reach, std::vector<Ghost<d>>& ghosts) const;
};
extern template struct Box<1>;
extern template struct Box<2>;
extern template struct Box<3>;

/// Ghosts through a function of the scene: make(x, reach, ghosts) appends them; x are the particles'
/// positions, `reach` the largest distance over which particles see each other. values(row, ghost) may then
/// set what the ghosts carry: it gets their row with the owner's values (the signs applied) and is called for
/// each ghost in each pass.
template <class Make, class Values>
struct GhostsOf {
    Make make;
    Values set;

    template <int d>
    void wrap(Vector<d>&) const {}
    template <int d>
    void add_ghosts(const Columns<d>& x, double reach, std::vector<Ghost<d>>& ghosts) const {
        make(x, reach, ghosts);
    }
    template <class Row, int d>
    void values(Row& row, const Ghost<d>& ghost) const {
        set(row, ghost);
    }
};
template <class Make, class Values>
GhostsOf(Make, Values) -> GhostsOf<Make, Values>;

}  // namespace sph
