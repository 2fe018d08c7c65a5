#pragma once
#include <functional>
#include <memory>

#include "chapters/06_finite_particle_method/rows.hpp"
#include "common/core/neighbours.hpp"

/// Rows for particles in any dimension: who is near, the densities, the fit, and what is done where the
/// neighbours do not determine it.
namespace sph {

/// Appends the images of particles at x within `reach` of the ends; empty: there are none.
template <int d>
using Images = std::function<void(const Columns<d>& x, double reach, std::vector<Ghost<d>>& images)>;

/// What happened to neighbourhoods that did not determine the fit.
struct Enlarged {
    std::size_t flagged = 0;     ///< had a condition number above the limit
    std::size_t left = 0;        ///< even with the largest support
    double largest_factor = 1;   ///< of h
    double worst_condition = 1;  ///< of those that were used
};

/// One object serves a whole run; its memory is kept.
template <int d>
class Estimates {
    struct Nothing {
        template <class Row>
        void operator()(Row&, const Ghost<d>&) const {}
    };
    struct Make {
        Images<d> images;
        void operator()(const Columns<d>& x, double reach, std::vector<Ghost<d>>& ghosts) const {
            if (images) images(x, reach, ghosts);
        }
    };

  public:
    /// Above this condition number a neighbourhood counts as singular: half of the digits are lost.
    static constexpr double largest_condition = 1e8;
    static constexpr double growth = 1.25;  ///< of the support, from round to round
    static constexpr int rounds = 24;       ///< at most: 200 times the support

    Estimates(std::shared_ptr<const Estimator<d>> estimator, AnyKernel<d> kernel, Images<d> images = {})
        : estimator_{std::move(estimator)},
          kernel_{kernel},
          neighbours_{{Make{std::move(images)}, Nothing{}}} {}

    const Estimator<d>& estimator() const { return *estimator_; }

    /// The rows of particles at x [length] with masses m and smoothing lengths h [length], one for all or one
    /// a particle. Neighbourhoods that do not determine the fit get a larger support, and are counted.
    /// Throws std::invalid_argument for an x or h that is not finite.
    const Rows<d>& at_particles(const Columns<d>& x, std::span<const double> m, std::span<const double> h);
    /// The rows at any places, with smoothing lengths h of the places, from the particles of the last
    /// at_particles().
    const Rows<d>& at(const Columns<d>& places, std::span<const double> h);
    const Enlarged& enlarged() const { return enlarged_; }
    /// Of the last rows: the condition number of each neighbourhood before any was enlarged.
    const Column& conditions() const { return conditions_; }
    /// Densities sum_j m_j W_ij of the last at_particles(), where the estimator needs them.
    const Column& density() const { return rho_; }
    const Rows<d>& rows() const { return rows_; }
    Counters& counters() { return neighbours_.counters(); }

  private:
    using Boundary = GhostsOf<Make, Nothing>;

    /// The r-th receiver's neighbours; `own`: which particle it is, or nobody.
    void gather(std::size_t r, double h, std::size_t own);
    void sum_densities(const Columns<d>& x, std::span<const double> h);
    const Rows<d>& fit(const Columns<d>& places, std::span<const double> h, bool own);
    /// Writes row i from the r-th receiver's neighbours; returns the condition number.
    double take_row(std::size_t r, std::size_t i, double h, bool own);
    void enlarge(const Columns<d>& places, std::span<const double> h, bool own);
    void find(const Columns<d>& places, std::span<const double> h, double factor);

    std::shared_ptr<const Estimator<d>> estimator_;
    AnyKernel<d> kernel_;
    Neighbours<d, Boundary> neighbours_;
    Columns<d> x_;
    Column m_, rho_, reach_;
    Neighbourhood<d> near_;
    Coefficients<d> row_;
    Rows<d> rows_;
    Enlarged enlarged_;
    Column conditions_;
    std::vector<std::size_t> flagged_;
    Indices scratch_;
};
extern template class Estimates<1>;
extern template class Estimates<2>;
extern template class Estimates<3>;

}  // namespace sph
