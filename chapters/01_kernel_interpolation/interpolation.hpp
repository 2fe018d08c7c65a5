#pragma once
#include <array>

#include "chapters/01_kernel_interpolation/any_kernel.hpp"
#include "chapters/01_kernel_interpolation/kernels.hpp"
#include "chapters/01_kernel_interpolation/smoothing.hpp"
#include "common/core/arrangement.hpp"
#include "common/core/pass.hpp"

/// The summation interpolant and its derivatives (Monaghan 2005, 2.8-2.31): each estimate is a small type
/// whose term reads like its equation; a pass sums those that are listed, and nothing else.
namespace sph {

/// Volume m/rho of a particle.
struct Volume {
    static constexpr std::string_view name = "volume";
    static constexpr bool positive = true;
    template <class T, int>
    struct In {
        T V{};
    };
};
/// The quantity that is interpolated, known at particles.
struct Quantity {
    static constexpr std::string_view name = "quantity";
    template <class T, int>
    struct In {
        T A{};
    };
};

/// rho_i = sum_j m_j W_ij   (Monaghan 2005, 2.9)
struct SummedDensity {
    using ReadsJ = List<Mass>;
    using Adds = List<Density>;
    void add(const auto&, const auto& j, const auto& pair, auto& sum) const { sum.rho += j.m * pair.W; }
};

// [value]
/// A_i = sum_j m_j/rho_j A_j W_ij   (2.8)
struct Value {
    static constexpr std::string_view name = "value";
    template <class T, int>
    struct In {
        T value{};
    };
    using ReadsJ = List<Volume, Quantity>;
    using Adds = List<Value>;
    void add(const auto&, const auto& j, const auto& pair, auto& sum) const {
        sum.value += j.V * j.A * pair.W;
    }
};
// [end]
/// grad A_i = sum_j m_j/rho_j A_j grad_i W_ij   (2.11): the exact gradient of (2.8); not zero for a constant.
struct PlainGradient {
    static constexpr std::string_view name = "plain gradient";
    template <class T, int d>
    struct In {
        Vec<T, d> plain{};
    };
    using ReadsJ = List<Volume, Quantity>;
    using Adds = List<PlainGradient>;
    void add(const auto&, const auto& j, const auto& pair, auto& sum) const {
        sum.plain += (j.V * j.A * pair.F) * pair.x_ij;
    }
};
// [gradient]
/// grad A_i = sum_j m_j/rho_j (A_j - A_i) grad_i W_ij   (2.14)
struct DifferenceGradient {
    static constexpr std::string_view name = "gradient of differences";
    template <class T, int d>
    struct In {
        Vec<T, d> gradient{};
    };
    using Reads = List<Quantity>;
    using ReadsJ = List<Volume>;
    using Adds = List<DifferenceGradient>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.gradient += (j.V * (j.A - i.A) * pair.F) * pair.x_ij;
    }
};
// [end]
/// grad A_i = 1/rho_i sum_j m_j (A_j - A_i) grad_i W_ij   (2.15)
struct DensityGradient {
    static constexpr std::string_view name = "gradient weighted by mass";
    template <class T, int d>
    struct In {
        Vec<T, d> weighted{};
    };
    using Reads = List<Quantity>;
    using ReadsI = List<Density>;
    using ReadsJ = List<Mass>;
    using Adds = List<DensityGradient>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.weighted += ((1 / i.rho) * j.m * (j.A - i.A) * pair.F) * pair.x_ij;
    }
};
/// lap A_i = sum_j m_j/rho_j A_j lap_i W_ij   (2.21 with its missing 1/rho_b; lap W = W'' + (d - 1) F)
struct TwiceDifferentiated {
    static constexpr std::string_view name = "twice differentiated";
    template <class T, int>
    struct In {
        T twice{};
    };
    using ReadsJ = List<Volume, Quantity>;
    using Adds = List<TwiceDifferentiated>;
    void add(const auto&, const auto& j, const auto& pair, auto& sum) const {
        const auto d = static_cast<double>(pair.x_ij.size());
        sum.twice += j.V * j.A * (pair.d2W + (d - 1) * pair.F);
    }
};
// [laplacian]
/// lap A_i = 2 sum_j m_j/rho_j (A_i - A_j) F_ij   (Brookshaw 1985; 2.24 with kappa = 1)
struct Brookshaw {
    static constexpr std::string_view name = "Laplacian";
    template <class T, int>
    struct In {
        T laplacian{};
    };
    using Reads = List<Quantity>;
    using ReadsJ = List<Volume>;
    using Adds = List<Brookshaw>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        sum.laplacian += 2.0 * j.V * (i.A - j.A) * pair.F;
    }
};
// [end]
/// d2A_i/dx^a dx^b = sum_j m_j/rho_j ((d + 2) x_ij^a x_ij^b / r^2 - delta^ab) (A_i - A_j) F_ij   (2.31; the
/// text after 2.34 gives 5 for the 4 in 3D, and d + 2 reproduces Brookshaw's form in 1D). The product with
/// A_i - A_j vanishes for the particle itself, so r = 0 may be replaced by any positive r.
struct TensorHessian {
    static constexpr std::string_view name = "second derivatives";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> hessian{};
    };
    using Reads = List<Quantity>;
    using ReadsJ = List<Volume>;
    using Adds = List<TensorHessian>;
    void add(const auto& i, const auto& j, const auto& pair, auto& sum) const {
        const std::size_t d = pair.x_ij.size();
        const Tile over_r2 = (pair.r * pair.r).max(1e-300).inverse();
        const Tile common = j.V * (i.A - j.A) * pair.F;
        for (std::size_t a = 0; a < d; ++a) {
            for (std::size_t b = 0; b < d; ++b) {
                const Tile direction = static_cast<double>(d + 2) * pair.x_ij[a] * pair.x_ij[b] * over_r2;
                sum.hessian[a][b] += (direction - (a == b ? 1.0 : 0.0)) * common;
            }
        }
    }
};

/// Particles of the unit box [0, 1]^d with mass 1/N each and a quantity A, interpolated with the kernel K at
/// smoothing length h by the listed estimates.
template <class K, class Boundary, class... Estimates>
class InterpolationWithin {
  public:
    using Kernel = K;
    static constexpr int d = K::dimension;
    using Scene = ParticlesOf<d, Union<List<Position, Mass, Density, Volume, Quantity>, List<Estimates...>>>;

    /// `points` in the box, `h` > 0 [box lengths]; A(position) is the quantity to interpolate.
    /// `summed_density`: rho_j = sum m W (2.9), as in SPH; otherwise rho = 1, the exact mean density.
    template <class Function>
    InterpolationWithin(Boundary boundary, const Columns<d>& points, double h, Function&& A,
                        bool summed_density = true, int threads = 1, K kernel = K{});

    std::size_t size() const noexcept { return particles_.size(); }
    Vector<d> position(std::size_t i) const { return load<d>(particles_, i, List<Position>{}).x; }
    /// Columns are named by the estimates: particles().value[i], particles().gradient[axis][i], ...
    const Scene& particles() const& noexcept { return particles_; }
    void particles() && = delete;  // what it refers to would be gone
    const ConstantH<K>& smoothing() const& noexcept { return smoothing_; }
    void smoothing() && = delete;  // what it refers to would be gone
    /// Computes the listed estimates at every particle. Neighbours are looked for in each call.
    /// Cost: a search and a pass.
    const Scene& estimate() { return estimate(effects()); }
    /// The same with estimates that have parameters.
    template <class... E>
    const Scene& estimate(const Effects<E...>& chosen) {
        sum_over_neighbours(particles_, neighbours_, smoothing_, chosen);
        return particles_;
    }
    /// The listed estimates that need no A_i or rho_i, at any positions in the box.
    auto estimate_at(const Columns<d>& positions) {
        Particles<d, Position, Estimates...> points{positions[0].size()};
        points.x = positions;
        neighbours_.find_around(positions, std::array{smoothing_.reach()}, particles_.x, Keep::nothing);
        sum_over_neighbours(points, particles_, neighbours_, smoothing_, effects());
        find();
        return points;
    }

    /// The listed estimates; those that ask for a smoothing length get it.
    auto effects() const { return Effects{with_h<Estimates>(smoothing_.h)...}; }

  private:
    template <class Estimate>
    static Estimate with_h(double h) {
        if constexpr (requires { Estimate{.h = h}; }) {
            return {.h = h};
        } else {
            return {};
        }
    }
    void find() { neighbours_.find(particles_.x, smoothing_.reach(), Support::gather, Keep::nothing); }

    Scene particles_;
    ConstantH<K> smoothing_;
    Neighbours<d, Boundary> neighbours_;
};

template <class K, class Boundary, class... Estimates>
template <class Function>
InterpolationWithin<K, Boundary, Estimates...>::InterpolationWithin(Boundary boundary,
                                                                    const Columns<d>& points, double h,
                                                                    Function&& A, bool summed_density,
                                                                    int threads, K kernel)
    : particles_{points[0].size()}, smoothing_{h, kernel}, neighbours_{std::move(boundary), threads} {
    const std::size_t n = particles_.size();
    particles_.x = points;
    particles_.m.assign(n, 1.0 / static_cast<double>(n));
    particles_.rho.assign(n, 1.0);
    find();
    if (summed_density)  // the same pass for all kernels
        sum_over_neighbours(particles_, neighbours_, ConstantH<AnyKernel<d>>{h, AnyKernel<d>{kernel.name}},
                            Effects{SummedDensity{}});
    for (std::size_t i = 0; i < n; ++i) {
        particles_.V[i] = particles_.m[i] / particles_.rho[i];
        particles_.A[i] = A(position(i));
    }
}

template <int d>
Box<d> periodic_unit_box() {
    Vector<d> low{}, high{};
    for (double& end : high) end = 1;
    return {low, high, Face::periodic};
}

/// The periodic unit box, which has no boundary to disturb a sum.
template <class K, class... Estimates>
struct Interpolation : InterpolationWithin<K, Box<K::dimension>, Estimates...> {
    template <class Function>
    Interpolation(const Columns<K::dimension>& points, double h, Function&& A, bool summed_density = true,
                  int threads = 1, K kernel = K{})
        : InterpolationWithin<K, Box<K::dimension>, Estimates...>{
              periodic_unit_box<K::dimension>(), points, h, A, summed_density, threads, kernel} {}
};

}  // namespace sph
