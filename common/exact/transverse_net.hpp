#pragma once
#include <cstddef>
#include <functional>
#include <span>

namespace exact::transverse {

/// Where two characteristics cross. With y = ln(T/T0) + c0^2 ln(tau/tau0), which is 0 in Bjorken's flow, the
/// transverse rapidity xi, and v = tanh xi:
///     psi = y + c0 xi,   d psi/d tau =   c0^2 v/(1 + c0 v) (c0/tau - 1/r)   on   dr/d tau = (v + c0)/(1 + c0
///     v), phi = y - c0 xi,   d phi/d tau = - c0^2 v/(1 - c0 v) (c0/tau + 1/r)   on   dr/d tau = (v - c0)/(1
///     - c0 v).
/// Source: Chen (2017), eqs 293-303, where 297 has d phi/d r for d psi/d r.
struct Node {
    double age;    ///< tau - tau0
    double depth;  ///< R + age - r, the way to the vacuum, exact where it is short
    double psi, phi;
    double grown;  ///< e^(2 xi)
    double slope;  ///< (e^(2 xi) - 1)/r, also on the axis
};

/// The net of characteristics of a TransverseFlow.
struct Net {
    double radius, tau0, c2;
    int level = 0;  ///< each level halves the spacing of the lines

    /// Above 0 once a node is too late to be of interest; it rises along all characteristics.
    using Late = std::function<double(const Node&)>;
    using Use = std::function<void(std::size_t row, std::span<const Node>)>;

    /// Hands over rows of nodes, each on a characteristic that runs outwards, from that of the edge at tau0
    /// to those which come from the axis. A row begins at the head of the rarefaction, where the fluid starts
    /// to move, or later on the axis. It ends with the first node that is `late`, or sooner: with one that
    /// does not exist, as the next characteristic inwards is never met, or behind all of these. `use` gets
    /// the rows that all levels share, and their number, which is the same on all levels. `age`: where most
    /// rows become late, it places them.
    void walk(const Late& late, double age, const Use& use) const;

    /// How many rows the head sends out. The last of them leaves where it meets the axis.
    std::size_t rows_from_head(double age) const;
};

}  // namespace exact::transverse
