#pragma once
#include <vector>

#include "chapters/07_godunov_sph/walls.hpp"
#include "common/exact/finite_volume_channel.hpp"
#include "common/exact/steady_supersonic.hpp"

/// A wedge in a channel: the channel, what theory says of the flow in it, and what is measured of a flow.
namespace sph::godunov {

/// A channel of height 1 in -1.5 < x < 1.5, whose floor rises by `angle` from x = -0.5 to 0 and then goes on
/// level. Gas of density 1 and speed of sound 1 enters with `mach`, so that this is its velocity.
struct WedgeChannel {
    double mach = 2, angle = 15, gamma = 1.4;  ///< [degrees]
    static constexpr double begin = -1.5, end = 1.5, edge = -0.5, corner = 0;

    double pressure() const { return 1 / gamma; }
    double energy() const { return 1 / (gamma * (gamma - 1)); }  ///< specific, thermal
    double radians() const;
    double floor(double x) const;
    std::vector<PolygonWall> walls() const;
    exact::ChannelShape cells(std::size_t n) const;  ///< 3 n times n
    /// Behind the attached shock from the edge, and behind the fan around the corner. Throw
    /// std::domain_error where the wedge is too blunt.
    exact::ObliqueShock shock() const;
    exact::PrandtlMeyer fan() const;
    /// The Mach number at a place that no wave from the ceiling has reached: of the stream, behind the shock,
    /// in the fan, or behind it.
    double exact_mach(double x, double y) const;
};

/// A flow on the cells of a channel, row by row from the floor: means of density, velocity and pressure.
struct ChannelFlow {
    exact::ChannelShape cells;
    std::vector<exact::GasState2D> state;
    double gamma = 1.4;

    const exact::GasState2D& at(std::size_t i, std::size_t j) const { return state[j * cells.nx + i]; }
    double x(std::size_t i) const { return (cells.node_x(i) + cells.node_x(i + 1)) / 2; }
    double y(std::size_t i, std::size_t j) const;
    double mach(std::size_t i, std::size_t j) const;
    /// Between the centres of cells, linearly; at a wall that of the last centre.
    double mach_at(double x, double y) const;
};
ChannelFlow flow_of(const exact::FiniteVolumeChannel& grid, double gamma);

/// Sums up particles and what they stand for, on the four cells around each.
class FlowMean {
  public:
    explicit FlowMean(const exact::ChannelShape& cells);
    /// A particle of the volume m/rho; outside of the channel it does not count.
    void add(double x, double y, double volume, const exact::GasState2D& state);
    /// A cell that no particle came near, at the entry, has the values of the next one downstream.
    ChannelFlow mean(double gamma) const;

  private:
    exact::ChannelShape cells_;
    std::vector<exact::GasState2D> sum_;
    std::vector<double> weight_;
};

struct Measured {
    double beta = 0;         ///< of the shock from the edge, [degrees]
    double mach_behind = 0;  ///< the mean between this shock and the fan
    double mach_after = 0;   ///< the mean behind the fan
    /// P/rho^gamma behind the fan, over theory's: in the lowest row of cells, and far from the floor.
    double entropy_at_floor = 0, entropy_above = 0;
    double least_mach = 0;    ///< of a cell
    double least_x = 0;       ///< where that is
    double sonic_height = 0;  ///< of the part at the ceiling where the flow is slower than sound
};
/// beta from a line through the places where P passes half of the theory's jump, in the columns of cells
/// that the shock crosses between y = 0.15 and 0.7; means over cells that are at least 0.05 from
/// the floor, and from shock and fan 0.3 of the distance of the corner from the shock (0.08 for the
/// defaults); behind the fan in 0.25 < x < 0.6; entropy above: 0.15 to 0.2 from the floor.
Measured measure(const WedgeChannel& channel, const ChannelFlow& flow);

}  // namespace sph::godunov
