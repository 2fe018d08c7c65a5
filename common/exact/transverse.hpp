#pragma once
#include <vector>

namespace exact {

/// A cylinder of fluid that expands along its axis as Bjorken's flow, and into the vacuum around it: at the
/// proper time tau0 it has the temperature 1 in r < R, where it rests transversally, p = c0^2 eps. From
/// outside to inside there are
///     the vacuum from the edge r = R + tau - tau0 on;
///     a rarefaction, whose head runs inwards at c0 and meets the axis at tau0 + R/c0;
///     inside the head Bjorken's flow, T = (tau0/tau)^(c0^2), and later what the rarefaction left of it.
/// Source: Chen (2017), section 5, eqs 272-303, after Hama & Pottag (1985); the corrections are in
/// transverse_net.hpp, and in 276, 277 tau - tau0 for tau. T is in units of its first value, c = 1.
struct TransverseFlow {
    double radius = 10;   ///< R, 1e-6..1e6 [L]
    double tau0 = 1;      ///< 1e-4 R..1e4 R [L]
    double c2 = 1.0 / 3;  ///< c0^2, speed of sound squared, 0.01..0.5

    void check() const;  ///< throws std::domain_error, which names the value, outside these ranges
    double sound_speed() const;
    double axis_time() const;          ///< tau0 + R/c0, when the rarefaction meets the axis
    double last_time() const;          ///< tau0 + 4 R/c0, up to which profiles are made
    double edge(double tau) const;     ///< where the vacuum begins
    double head(double tau) const;     ///< where Bjorken's flow ends; 0 from axis_time() on
    double bjorken(double tau) const;  ///< its temperature
};

/// The flow at one proper time, by characteristics: the net of transverse_net.hpp on three or more levels,
/// each of second order, extrapolated to lines without distance (Richardson).
///
/// Accuracy of T, absolute, for c0^2 <= 1/3: measured 6e-8 until the head meets the axis, against a spectral
/// solution, and 2e-6 later, against finer lines; 1e-6 for c0^2 to 0.5, and 1e-5 where the rapidity
/// exceeds 5. The rapidity is ten times less accurate. Beyond the outermost row of the net, about 1e-8 of the
/// age from the vacuum, both continue as a power and a logarithm of that distance. Cost: 0.1 seconds to make
/// at R = 10, tau = 10, 0.6 after the axis, ten times that for c0^2 > 0.4; a microsecond for each place.
class TransverseProfile {
  public:
    /// tau in tau0..last_time(). Throws std::domain_error, which names the value, outside this range and
    /// those of the flow.
    TransverseProfile(const TransverseFlow& flow, double tau);

    struct State {
        double temperature;  ///< T/T0
        double rapidity;     ///< xi, u^r = sinh xi; 0 in the vacuum
        double s_star;       ///< tau s u^tau, s = T^(1/c0^2): its integral over the disc is pi R^2 tau0
    };
    /// At r >= 0, finite; throws std::domain_error otherwise. In the vacuum temperature and s_star are 0.
    State at(double r) const;

    double tau() const { return tau_; }
    double estimated_error() const { return error_; }  ///< of T, from the last two extrapolations

  private:
    /// On one line outwards: what its place is measured by, and psi, phi there.
    struct Point {
        double x, psi, phi;
    };
    using Table = std::vector<Point>;
    Point at_point(double r) const;
    double depth(double r) const { return flow_.radius - r + (tau_ - flow_.tau0); }

    TransverseFlow flow_;
    double tau_, error_ = 0;
    double inner_end_ = 0;  ///< r of the head, and later of the line that it sent outwards from the axis
    Table outer_{};         ///< x = ln(edge - r), increasing
    Table inner_{};         ///< x = r, with its mirror image; empty before axis_time()
};

/// A place of a surface in the (tau, r) plane.
struct SurfaceEvent {
    double tau, r;
};

/// Where the fluid has the temperature T_d, at which it breaks up into particles: from the edge at tau0,
/// where all temperatures begin, outwards and then inwards to the axis, by one net as that of
/// TransverseProfile. If T_d is reached inside the head, the last two events are at one tau, at the head and
/// on the axis. If it is reached behind the line which the head sends out from the axis, tau falls again
/// towards the axis: there the focused rarefaction leaves the fluid coolest. T_d in [lowest_surface(flow),
/// 1). Throws std::domain_error, which names the value, outside this range and those of the flow.
std::vector<SurfaceEvent> freeze_out_surface(const TransverseFlow& flow, double temperature);

/// e^(-5 c0): below, the outermost lines of the net are not far enough out.
double lowest_surface(const TransverseFlow& flow);

}  // namespace exact
