#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "common/exact/riemann.hpp"

namespace exact {

/// The interacting blast waves of Woodward and Colella: an ideal gas of gamma = 1.4 at rest between walls at
/// x = 0 and x = 1, rho = 1, p = 1000 for x < 0.1, 100 for x > 0.9, and 0.01 between, at t = 0.038. Two
/// strong shocks have met, and run back through the contacts that followed them. Source: Woodward & Colella,
/// J. Comput. Phys. 54 (1984) 115, section IV.a.
///
/// A numerical reference, not an exact solution: FiniteVolume in the Lagrangian frame with quiet shocks and
/// courant = 0.4, and between its nodes straight lines. All is dimensionless.
class WoodwardColella {
  public:
    static constexpr double gamma = 1.4, time = 0.038;

    struct Node {
        double x, rho, v, p;
    };

    /// The stored reference: 1029 nodes of 51200 cells. L1 of the difference to 25600 cells over L1,
    /// measured: rho 2.1e-4, v 1.9e-4, p 8.9e-5, half of what it is from 12800 to 25600 cells, so that the
    /// reference is as far from the truth again. The lines between the nodes add rho 7e-5, v 1.1e-4, p 5e-5.
    /// Beside the contact at x = 0.7648 three cells, 9e-6 wide together, overshoot the density of 6.3 by up
    /// to 1.2; the highest elsewhere is 6.47, at 0.779.
    WoodwardColella();
    /// The same computed now, with `cells` of equal mass in 10..1,000,000; every centre is a node. `pause` is
    /// called a hundred times on the way and may throw. Throws std::domain_error, which names the value,
    /// outside this range. Cost: 0.07 microseconds times cells^2, that is 0.1 s for 1600 cells and four
    /// minutes for 51200.
    explicit WoodwardColella(std::size_t cells, const std::function<void()>& pause = {});

    /// At x in 0..1. Throws std::domain_error, which names the value, outside this range.
    Riemann::Point at(double x) const;

    std::size_t cells() const noexcept { return cells_; }
    std::span<const Node> nodes() const& noexcept { return nodes_; }
    void nodes() && = delete;  // what it refers to would be gone
    /// As few of the nodes as it takes for the straight lines between them to pass every other node within
    /// `tolerance` > 0, relative for rho and p, and for v of half its largest value.
    std::vector<Node> thinned(double tolerance) const;

  private:
    std::size_t cells_;
    std::vector<Node> nodes_;  ///< x increases from 0 to 1
};

}  // namespace exact
