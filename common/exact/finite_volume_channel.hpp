#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "common/exact/finite_volume_2d.hpp"

namespace exact {

/// A channel between two walls, cut into nx times ny quadrilaterals that follow them: equally wide in x, and
/// between the walls equally high at each x.
struct ChannelShape {
    double x_begin = 0, x_end = 1;
    std::function<double(double x)> floor, ceiling;  ///< floor < ceiling on x_begin..x_end
    std::size_t nx = 2, ny = 2;                      ///< two and above

    double dx() const { return (x_end - x_begin) / static_cast<double>(nx); }
    double node_x(std::size_t i) const { return x_begin + static_cast<double>(i) * dx(); }
    double node_y(std::size_t i, std::size_t j) const {
        const double share = static_cast<double>(j) / static_cast<double>(ny), x = node_x(i);
        return (1 - share) * floor(x) + share * ceiling(x);
    }
};

/// The Euler equations of an ideal gas in a channel by finite volumes of second order: slopes from cell to
/// cell, limited as in FiniteVolume2D, HLLC across each face, and Heun's steps. What enters at x_begin is
/// given, and what leaves at x_end leaves, as it does where the flow is supersonic; walls are slippery. The
/// competitor of particles in a channel that is not a box (which FiniteVolume2D is for).
/// Source: Toro, Riemann Solvers (2009), sections 16.7.3 (cells of any shape), 10.4-10.5 (HLLC).
/// Cost: 0.1 microseconds a cell and step.
class FiniteVolumeChannel {
  public:
    /// All cells begin with the state `entering` (rho, p > 0), gamma in (1, 100], courant in (0, 1].
    /// Throws std::domain_error, which names the value.
    FiniteVolumeChannel(const ChannelShape& shape, const GasState2D& entering, double gamma,
                        double courant = 0.8);
    /// Begins with the cells of a solution on another grid of the same channel, at its time.
    FiniteVolumeChannel(const ChannelShape& shape, const FiniteVolumeChannel& coarser);

    /// Steps to time `t` >= time() exactly. Throws UnphysicalCell where a cell becomes unphysical.
    void advance_to(double t);

    const ChannelShape& shape() const noexcept { return shape_; }
    double time() const noexcept { return time_; }
    long steps() const noexcept { return steps_; }
    const GasState2D& at(std::size_t i, std::size_t j) const { return gas_[index(i, j)]; }
    double x(std::size_t i) const { return (shape_.node_x(i) + shape_.node_x(i + 1)) / 2; }
    double y(std::size_t i, std::size_t j) const;
    /// The state of the cell that holds the point, which must lie in the channel.
    const GasState2D& at_point(double x, double y) const;
    /// The flux of mass through the column of faces at node i; the same for all i where the flow is steady.
    double mass_flux(std::size_t i);

  private:
    static constexpr std::size_t ghosts = 2;
    using Conserved = std::array<double, 4>;  // rho, rho vx, rho vy, E by area, or fluxes of them
    struct Face {
        double nx, ny, length;
    };

    std::size_t index(std::size_t i, std::size_t j) const { return (j + ghosts) * stride_ + i + ghosts; }
    void measure_cells();
    void fill_ghosts();
    void find_fluxes();
    Conserved flux(const GasState2D& low, const GasState2D& high, const Face& face);
    Conserved conserved(const GasState2D& gas) const;
    void set(std::size_t k, const Conserved& value, const char* when);
    void step(double dt);

    ChannelShape shape_;
    GasState2D entering_;
    double gamma_, courant_, time_ = 0;
    long steps_ = 0;
    std::size_t stride_;
    std::vector<double> area_, rate_;    // of cells; of the waves through a cell's faces [area/time]
    std::vector<Face> face_x_, face_y_;  // on the low side of each cell
    std::vector<GasState2D> gas_, slope_x_, slope_y_;
    std::vector<Conserved> flux_x_, flux_y_, before_;
    double fastest_ = 0;
};

}  // namespace exact
