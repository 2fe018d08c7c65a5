#pragma once
#include <array>
#include <limits>
#include <vector>

#include "chapters/06_finite_particle_method/bases.hpp"
#include "common/core/tile.hpp"

/// One particle and those around it, and what an estimate makes of them: a row of coefficients.
namespace sph {

/// The neighbours of a place, as columns that are padded to whole tiles; lanes behind the last neighbour have
/// volume zero.
template <int d>
struct Neighbourhood {
    static constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();
    Columns<d> offset;          ///< x_j - x_i
    Column mass, volume;        ///< m_j; V_j = m_j/rho_j
    std::size_t count = 0;      ///< neighbours
    std::size_t self = nobody;  ///< which of them is the particle itself
    double h = 1;               ///< > 0, of the place

    std::size_t tiles() const { return (count + tile_width - 1) / tile_width; }
    Vec<Tile, d> x_ji(std::size_t t) const {
        Vec<Tile, d> x;
        for (std::size_t a = 0; a < d; ++a) x[a] = Tile::load(offset[a].data() + t * tile_width);
        return x;
    }
    Tile m(std::size_t t) const { return Tile::load(mass.data() + t * tile_width); }
    Tile V(std::size_t t) const { return Tile::load(volume.data() + t * tile_width); }
    /// Makes room for `n` neighbours.
    void resize(std::size_t n) {
        count = n;
        const std::size_t padded = tiles() * tile_width;
        for (std::size_t a = 0; a < d; ++a) offset[a].assign(padded, 0.0);
        mass.assign(padded, 0.0);
        volume.assign(padded, 0.0);
    }
};

/// For each neighbour what value, first and second derivatives take of f_j, in the order of Taylor's terms.
template <int d>
class Coefficients {
  public:
    void resize(std::size_t padded) {
        for (Column& one : rows_) one.assign(padded, 0.0);
    }
    double* of(std::size_t k) { return rows_[k].data(); }
    const double* of(std::size_t k) const { return rows_[k].data(); }

  private:
    std::array<Column, derivatives<d>> rows_;
};

/// A way to estimate value and derivatives from neighbours.
template <int d>
class Estimator {
  public:
    virtual ~Estimator() = default;
    /// Fills the coefficients; returns the condition number of the matrix that was solved (its 1-norm times
    /// that of its inverse), infinite where it is singular, 1 where nothing is solved.
    virtual double coefficients(const Neighbourhood<d>& near, const AnyKernel<d>& kernel,
                                Coefficients<d>& out) const = 0;
    /// Whether V_j matters; where not, all count as 1.
    virtual bool needs_volumes() const = 0;
    /// Whether it has second derivatives of its own; where not, the first one is taken twice.
    virtual bool has_second() const = 0;
};

}  // namespace sph
