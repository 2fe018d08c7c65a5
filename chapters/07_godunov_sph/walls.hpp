#pragma once
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "common/core/boundary.hpp"
#include "common/core/particles.hpp"

/// Walls of straight pieces, as boundaries (common/core/boundary.hpp): behind a wall stand the mirror images
/// of the particles before it. And a channel between such walls, into which gas streams.
namespace sph {

/// What is before a plane, seen in it: v - 2 (n . v) n, and the same for both directions of a tensor. Numbers
/// stay.
inline void mirror(double&, const Vector<2>&) {}
template <class T>
void mirror(Vec<T, 2>& value, const Vector<2>& n) {
    for (T& one : value) mirror(one, n);
    const T through = n[0] * value[0] + n[1] * value[1];
    for (std::size_t a = 0; a < 2; ++a) value[a] -= 2 * n[a] * through;
}

/// A wall in the plane, straight from corner to corner; the gas is on the left of one who walks along it. Its
/// first and last piece go on for ever. The line that halves the angle behind a corner divides what is behind
/// the wall: each place there belongs to one piece, and holds the image of one place before that. So images
/// are neither missing nor double, at corners into the gas as at corners away from it.
class PolygonWall {
  public:
    struct Piece {
        Vector<2> begin{}, end{}, along{}, normal{};  ///< normal: into the gas
        Vector<2> from{}, to{};  ///< across the dividing lines at both ends, 0 where there is none
        /// How far a place is before the piece's line.
        double before(const Vector<2>& x) const { return dot(normal, x - begin); }
        /// Whether a place is behind this piece, and not behind the next ones.
        bool is_behind(const Vector<2>& x) const {
            return before(x) < 0 && dot(from, x - begin) >= 0 && dot(to, x - end) <= 0;
        }
    };

    /// Two corners or more. Throws std::invalid_argument for corners on top of each other, and for one that
    /// leaves the gas less than 120 degrees: behind it single images do not reach far enough.
    explicit PolygonWall(const std::vector<Vector<2>>& corners) {
        if (corners.size() < 2) throw std::invalid_argument{"PolygonWall: two corners or more"};
        for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
            const Vector<2> way = corners[k + 1] - corners[k];
            const double length = std::hypot(way[0], way[1]);
            if (!(length > 0)) throw std::invalid_argument{"PolygonWall: two corners on top of each other"};
            const Vector<2> along = (1 / length) * way;
            pieces_.push_back({corners[k], corners[k + 1], along, {-along[1], along[0]}});
        }
        for (std::size_t k = 0; k + 1 < pieces_.size(); ++k) divide(pieces_[k], pieces_[k + 1]);
    }
    const std::vector<Piece>& pieces() const& noexcept { return pieces_; }
    void pieces() && = delete;  // what it refers to would be gone

    /// The piece behind which a place is; none for a place before the wall.
    const Piece* behind(const Vector<2>& x) const {
        const auto found = std::find_if(pieces_.begin(), pieces_.end(),
                                        [&](const Piece& piece) { return piece.is_behind(x); });
        return found == pieces_.end() ? nullptr : &*found;
    }

  private:
    static void divide(Piece& piece, Piece& next) {
        constexpr double sharpest = 0.5;  // the cosine of a turn by 60 degrees
        const double cosine = dot(piece.along, next.along);
        const bool into_gas = dot(piece.normal, next.along) > 0;
        if (into_gas && cosine < sharpest)
            throw std::invalid_argument{"PolygonWall: a corner leaves the gas less than 120 degrees"};
        piece.to = next.from = piece.along + next.along;
    }

    std::vector<Piece> pieces_;
};

/// A channel along x between walls. Gas streams in faster than sound, as columns of a square lattice one
/// `spacing` behind the other: ahead of the first column stand images of the first `columns` ones, so that no
/// particle of the stream sees that it begins. At the other end there is nothing, which a flow that leaves
/// faster than sound does not feel.
struct OpenChannel {
    std::vector<PolygonWall> walls;
    double spacing = 1;
    int columns = 8;  ///< as wide as what a particle of the stream sees, or wider

    void wrap(Vector<2>&) const {}
    double period() const { return columns * spacing; }
    /// Whether particles at x belong to the columns that have images; `first` is where the first column is.
    bool is_repeated(double x, double first) const { return x < first + period() - 0.5 * spacing; }

    // [ghosts]
    void add_ghosts(const Columns<2>& x, double reach, std::vector<Ghost<2>>& ghosts) const {
        const auto add_images = [&](const Ghost<2>& of) {
            for (const PolygonWall& wall : walls) {
                for (const PolygonWall::Piece& piece : wall.pieces()) {
                    const double before = piece.before(of.x);
                    if (before < 0 || before > reach) continue;
                    const Vector<2> image = of.x - 2 * before * piece.normal;
                    if (piece.is_behind(image)) ghosts.push_back({of.owner, image, {1, 1}});
                }
            }
        };
        const double first = *std::min_element(x[0].begin(), x[0].end());
        for (std::uint32_t i = 0; i < x[0].size(); ++i) {
            const Vector<2> at{x[0][i], x[1][i]};
            add_images({i, at, {1, 1}});
            if (!is_repeated(at[0], first)) continue;
            ghosts.push_back({i, at - Vector<2>{period(), 0}, {1, 1}});
            add_images(Ghost<2>{ghosts.back()});
        }
    }
    /// A ghost behind a wall has its owner's vectors in the mirror.
    template <class Row, int d>
    void values(Row& row, const Ghost<d>& ghost) const {
        for (const PolygonWall& wall : walls) {
            if (const auto* piece = wall.behind(ghost.x))
                mirror_all(row, piece->normal, typename Row::Names{});
        }
    }
    // [end]

  private:
    template <class Row, class... C>
    static void mirror_all(Row& row, const Vector<2>& n, List<C...>) {
        (mirror(member<C, double, 2>(row), n), ...);
    }
};

}  // namespace sph
