#pragma once
#include <stdexcept>
#include <string>

#include "chapters/06_finite_particle_method/burgers_line.hpp"

/// Central differences on the even points i/(n - 1) of a line from 0 to 1, as rows, for functions that are
/// odd at both ends: points beyond them are images. The competitor.
namespace sph::fpm {

class Differences final : public RowSource {
  public:
    /// Of order 2 or 4. Throws std::invalid_argument for another one, or fewer than 5 points.
    Differences(std::size_t n, int order) {
        if ((order != 2 && order != 4) || n < 5)
            throw std::invalid_argument{"no differences of order " + std::to_string(order) + " on " +
                                        std::to_string(n) + " points"};
        const auto last = static_cast<long>(n) - 1;
        const double dx = 1 / static_cast<double>(last);
        // Of distances 0, 1, 2, times dx and dx^2.
        const Column slope = order == 2 ? Column{0, 0.5} : Column{0, 2.0 / 3, -1.0 / 12};
        const Column curvature = order == 2 ? Column{-2, 1} : Column{-2.5, 4.0 / 3, -1.0 / 12};
        rows_.reset(n);
        for (long i = 0; i <= last; ++i) {
            rows_.begin(static_cast<std::size_t>(i));
            const auto reach = static_cast<long>(slope.size()) - 1;
            for (long k = -reach; k <= reach; ++k) {
                const long at = i + k, inside = at < 0 ? -at : at > last ? 2 * last - at : at;
                const auto distance = static_cast<std::size_t>(k < 0 ? -k : k);
                rows_.add(static_cast<std::uint32_t>(inside), at == inside ? 1 : -1,
                          {k == 0 ? 1.0 : 0.0, (k < 0 ? -1 : 1) * slope[distance] / dx,
                           curvature[distance] / (dx * dx)});
            }
        }
    }
    const Rows<1>& at(const BurgersParticles&) override { return rows_; }
    bool twice() const override { return false; }

  private:
    Rows<1> rows_;
};

}  // namespace sph::fpm
