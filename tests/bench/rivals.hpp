#pragma once
#include <cstdint>
#include <vector>

#include "chapters/01_kernel_interpolation/scenes/naive.hpp"
#include "tests/bench/gas.hpp"

/// How the same pass is usually written: particles as structures, one pair at a time. Each way computes what
/// the engine computes, from the same particles and ghosts; `worst_difference` makes sure of it.
namespace bench {

/// Everything about one particle in one structure.
template <int d>
struct Structure {
    double x[d], v[d], m, rho, p, c_s;
    double rho_sum, drho_dt, dv_dt[d], du_dt;
    std::uint32_t owner;  // a ghost's; of a particle itself
    bool ghost;
    std::int32_t next;  // in its cell
};

template <int d>
class Rivals {
  public:
    /// Copies the gas and its ghosts; its neighbours must have been found.
    explicit Rivals(const Gas<d>& gas);

    /// Linked lists of the particles in each cell, in the order in which they were made: what one writes
    /// first.
    void linked_list();
    /// Particles sorted by cell, neighbouring cells in one run.
    void sorted_cells();
    /// A ready list of neighbours, one pair at a time.
    void from_list();
    /// A ready list of pairs, each computed once for both particles (Newton's third law).
    void from_half_list();

    /// The largest difference from the sums of the engine, relative to the largest sum.
    double worst_difference(const GasParticles<d>& engine) const;

  private:
    using Kernel = sph::interpolation::PiecewiseCubic<d>;
    using S = Structure<d>;
    static constexpr int axis_cells(double width) { return static_cast<int>(1 / width) + 3; }
    std::size_t cell_of(const S& s) const;
    template <class Visit>
    void for_each_cell_around(const S& s, Visit&& visit) const;
    void clear();
    void add(S& i, const S& j) const;
    void add_both(S& i, S& j) const;

    double h_;
    int cells_;  // along each axis; the first and the last hold ghosts
    double width_;
    std::vector<S> unsorted_, sorted_;
    std::vector<S>* used_ = &unsorted_;  // by the way that ran last
    std::vector<std::int32_t> first_;
    std::vector<std::uint32_t> start_;
    std::vector<std::size_t> list_start_, half_start_;
    std::vector<std::uint32_t> list_, half_;
};
extern template class Rivals<2>;
extern template class Rivals<3>;

}  // namespace bench
