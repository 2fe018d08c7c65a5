#pragma once
#include "chapters/01_kernel_interpolation/gaussians.hpp"
#include "chapters/01_kernel_interpolation/splines.hpp"
#include "chapters/03_euler_sph/resolution.hpp"

/// Kernels with their convolutions with themselves, and where h comes from. The density of Godunov SPH takes
/// a kernel W; its forces take the integral of W(x - x_i) W(x - x_j) over x, a wider kernel of x_i - x_j.
namespace sph {

/// The Gaussian, whose convolution is the Gaussian of sqrt2 h   (Inutsuka 2002, 9 and 51). Pairs farther than
/// cut sqrt2 h from each other are left out: there the wide kernel has fallen to exp(-cut^2).
///     variance   the mean square of one component of x under W [h^2]
///     product    the same of W_i W_j around half-way [h^2]
///     bend       how much too low the density of a sine wave is, in (k h)^2, at h = spacing
///     reach2     three times the mean square of one component of x under the wide kernel [h^2]
/// In d dimensions V is interpolated along a pair's line only. What that leaves out across it, on average
/// over directions, stands in product: with the factor 1 + (d - 1)^2/(3 d) long waves of the density at
/// uniform pressure are without force, as on a line   (measured: tests/07_godunov_sph).
template <int d, int cut = 4>
struct ConvolvedGaussian : Gaussian<d> {
    static constexpr double support = cut * std::numbers::sqrt2;
    static constexpr double variance = 0.5, bend = 0.25, reach2 = 3;
    static constexpr double product = 0.25 * (1 + (d - 1) * (d - 1) / (3.0 * d));
    template <class H>
    static Tile wide_W(const Tile& r, const H& h) {
        return Gaussian<d, cut>::W(r, std::numbers::sqrt2 * h);
    }
    template <class H>
    static Tile wide_F(const Tile& r, const H& h) {
        return Gaussian<d, cut>::F(r, std::numbers::sqrt2 * h);
    }
};
/// The quadratic spline M_3, whose convolution is M_6, the quintic: exactly so on a line, since M_n is the
/// box convolved n times (Schoenberg 1946). Half as wide as the Gaussian of the same h. Three neighbours make
/// its density, so that bend is that of their difference, 1/6; product then keeps uniform pressure without
/// force. For a line: in the plane and in space its density answers the compression of a lattice by several
/// per cent too little or too much.
template <int d>
struct ConvolvedQuadratic : QuadraticSpline<d> {
    static constexpr double support = 3;
    static constexpr double variance = 0.25, product = 1.0 / 24, bend = 1.0 / 6, reach2 = 1.5;
    template <class H>
    static Tile wide_W(const Tile& r, const H& h) {
        return QuinticSpline<d>::W(r, h);
    }
    template <class H>
    static Tile wide_F(const Tile& r, const H& h) {
        return QuinticSpline<d>::F(r, h);
    }
};

/// h from a density that is summed with a wider kernel, as the paper has it   (Inutsuka 2002, 81 and 82):
///     h_i = eta (m_i/rho*_i)^(1/d),   rho*_i = sum_j m_j W(x_ij, C_smooth h_i),
/// and then rho_i = sum_j m_j W(x_ij, h_i). The first two are chapter 3's for the width C_smooth eta.
template <class K>
class SmoothWidth : public ConsistentH<K> {
    using Base = ConsistentH<K>;

  public:
    /// eta > 0, C_smooth >= 1 [-]; close: of ConsistentH.
    SmoothWidth(double eta, double C_smooth, double close)
        : Base{HRule{eta * C_smooth}, close}, C_smooth_{C_smooth} {}
    template <class P>
    void start(P& p) const {
        Base::start(p);
        for (double& h : p.h) h /= C_smooth_;
    }
    template <class P, class N>
    void resolve(P& p, N& neighbours) {
        for (double& h : p.h) h *= C_smooth_;
        Base::resolve(p, neighbours);
        for (double& h : p.h) h /= C_smooth_;
        sum_over_neighbours(p, neighbours, OwnH<K>{}, Effects{SummedDensity{}});
    }

  private:
    double C_smooth_;
};

/// One h for all   (Inutsuka 2002, section 3.1).
template <class K>
struct SameWidth {
    using Kernel = K;
    using Counts = OfMass;
    using Columns = List<SmoothingLength>;

    double h;

    BothH<K> smoothing() const { return {}; }
    template <class P>
    void start(P& p) const {
        p.h.assign(p.size(), h);
    }
    template <class P, class N>
    void resolve(P& p, N& neighbours) const {
        neighbours.find(p.x, K::support * h);
        sum_over_neighbours(p, neighbours, OwnH<K>{}, Effects{SummedDensity{}});
    }
};

}  // namespace sph
