#pragma once

/// A bar of equal masses and springs between fixed ends, one mass of which is struck at t = 0:
///     d2u_j/dt2 = (c/dx)^2 (u_{j+1} - 2 u_j + u_{j-1}),   u_0 = u_{N+1} = 0,   u(0) = 0,  du_s/dt(0) = V.
/// That is the discrete wave equation, and linear finite elements with lumped masses. Its solution is the sum
/// of its N modes:
///     u_j = 2V/(N+1) sum_m sin(m pi s/(N+1)) sin(m pi j/(N+1)) sin(omega_m t)/omega_m,
///     omega_m = 2 c/dx sin(m pi/(2 (N+1))).
/// A tension of the whole bar does not enter: along a line the forces on either side of a mass cancel.
namespace exact {

/// Units: dx and dx/c are those of length and time. Accuracy: 1e-14 V N.
class StruckBar {
  public:
    static constexpr int most_masses = 100000;
    static constexpr double largest_velocity = 1e50, largest_time = 1e6;

    /// N in 1..most_masses free masses, number 1 beside the left end; the struck one, s in 1..N; velocity V
    /// in
    /// +-largest_velocity [c]. Throws std::domain_error, which names the value, outside these ranges.
    StruckBar(int masses, int struck, double velocity);

    /// u_j(t) [dx] of mass j in 0..N+1, t in 0..largest_time [dx/c]; throws std::domain_error, which names
    /// the value, elsewhere. Cost: N sines.
    double displacement(int mass, double t) const;
    /// du_j/dt [c]; the same ranges.
    double velocity(int mass, double t) const;

    /// omega_m [c/dx] of mode m in 1..N.
    double frequency(int mode) const;

  private:
    double sum_of_modes(int mass, double t, bool rate) const;

    int masses_, struck_;
    double velocity_;
};

}  // namespace exact
