#pragma once
#include <algorithm>
#include <functional>
#include <memory>

#include "common/core/pass.hpp"

namespace sph {

/// One pass over the pairs of given points with only the listed effects, on particles that hold only the
/// columns that these and the smoothing name; all ones but for the positions.
template <int d, class Boundary, class Smoothing, class... E>
class Listed {
  public:
    /// `h`: what the column of smoothing lengths holds, if there is one; reach: how far particles see.
    Listed(const Columns<d>& x, Boundary boundary, double h, double reach, Smoothing smoothing, E... effects)
        : particles_{x[0].size()},
          neighbours_{std::move(boundary)},
          smoothing_{smoothing},
          effects_{effects...} {
        particles_.for_each_column([&](auto, Column& column) {
            std::fill(column.begin(), column.end(), 1.0);
            ++columns_;
        });
        particles_.x = x;
        if constexpr (requires { particles_.h[0]; }) particles_.h.assign(particles_.size(), h);
        neighbours_.find(particles_.x, reach);
    }
    void pass() { sum_over_neighbours(particles_, neighbours_, smoothing_, effects_); }
    std::size_t size() const { return particles_.size(); }
    std::size_t pairs() const { return neighbours_.pairs(); }
    std::size_t columns() const { return columns_; }

  private:
    using Needed = Effects<Smoothing, E...>;
    ParticlesOf<d, Union<List<Position>, typename Needed::ReadI, typename Needed::ReadJ,
                         typename Effects<E...>::Stored>>
        particles_;
    Neighbours<d, Boundary> neighbours_;
    Smoothing smoothing_;
    Effects<E...> effects_;
    std::size_t columns_ = 0;
};

}  // namespace sph
