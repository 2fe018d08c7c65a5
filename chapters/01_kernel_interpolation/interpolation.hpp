#pragma once
#include <Eigen/Core>
#include <tuple>
#include <utility>

#include "chapters/01_kernel_interpolation/kernels.hpp"
#include "chapters/01_kernel_interpolation/particles.hpp"
#include "common/app/program.hpp"

/// The summation interpolant and its derivatives (Monaghan 2005, 2.8-2.31): each estimate is a small type
/// whose term reads like its equation; evaluate() sums those that are listed, in one pass, and nothing else.
namespace sph {

/// Neighbours are summed eight at a time: one register of doubles with AVX-512, two with AVX2.
inline constexpr int tile_width = 8;
using Tile = Eigen::Array<double, tile_width, 1>;

/// What the terms may use: the point i and a tile of its neighbours j. What no listed estimate uses, the
/// compiler removes.
template <int d>
struct Pairs {
    double A_i = 0, rho_i = 0;
    std::array<Tile, d> x_ij;  ///< x_i - x_j
    Tile r, W, F, d2W;         ///< distance, W, gradient factor (grad_i W = x_ij F), d2W/dr2
    Tile m, V, A;              ///< of j: mass, volume m/rho, the interpolated quantity
};
template <int d>
using Components = std::array<Tile, d>;

/// A_i = sum_j m_j/rho_j A_j W_ij   (Monaghan 2005, 2.8)
struct Value {
    template <int d>
    static std::array<Tile, 1> term(const Pairs<d>& p) {
        return {p.V * p.A * p.W};
    }
};
/// grad A_i = sum_j m_j/rho_j A_j grad_i W_ij   (2.11): the exact gradient of (2.8); not zero for a constant.
struct PlainGradient {
    template <int d>
    static Components<d> term(const Pairs<d>& p) {
        return along<d>(p, p.V * p.A * p.F);
    }
    /// x_ij times a scalar of the pair.
    template <int d>
    static Components<d> along(const Pairs<d>& p, const Tile& scalar) {
        Components<d> result;
        for (std::size_t a = 0; a < d; ++a) result[a] = scalar * p.x_ij[a];
        return result;
    }
};
/// grad A_i = sum_j m_j/rho_j (A_j - A_i) grad_i W_ij   (2.14, that is 2.13 with Phi = 1)
struct DifferenceGradient {
    template <int d>
    static Components<d> term(const Pairs<d>& p) {
        return PlainGradient::along<d>(p, p.V * (p.A - p.A_i) * p.F);
    }
};
/// grad A_i = 1/rho_i sum_j m_j (A_j - A_i) grad_i W_ij   (2.15, that is 2.13 with Phi = rho)
struct DensityGradient {
    template <int d>
    static Components<d> term(const Pairs<d>& p) {
        return PlainGradient::along<d>(p, (1 / p.rho_i) * p.m * (p.A - p.A_i) * p.F);
    }
};
/// lap A_i = sum_j m_j/rho_j A_j lap_i W_ij   (2.21 with its missing 1/rho_b; lap W = W'' + (d - 1) F)
struct TwiceDifferentiated {
    template <int d>
    static std::array<Tile, 1> term(const Pairs<d>& p) {
        return {p.V * p.A * (p.d2W + double(d - 1) * p.F)};
    }
};
/// lap A_i = 2 sum_j m_j/rho_j (A_i - A_j) F_ij   (Brookshaw 1985; 2.24 with kappa = 1)
struct Brookshaw {
    template <int d>
    static std::array<Tile, 1> term(const Pairs<d>& p) {
        return {2.0 * p.V * (p.A_i - p.A) * p.F};
    }
};
/// d2A_i/dx^a dx^b = sum_j m_j/rho_j ((d + 2) x_ij^a x_ij^b / r^2 - delta^ab) (A_i - A_j) F_ij   (2.31; the
/// text after 2.34 gives 5 for the 4 in 3D, and d + 2 reproduces Brookshaw's form in 1D). Components: xx; xx
/// xy yy; xx xy xz yy yz zz. The product with A_i - A_j vanishes for the particle itself, so r = 0 may be
/// replaced by any positive r.
struct TensorHessian {
    template <int d>
    static std::array<Tile, d*(d + 1) / 2> term(const Pairs<d>& p) {
        const Tile over_r2 = (p.r * p.r).max(1e-300).inverse();
        const Tile common = p.V * (p.A_i - p.A) * p.F;
        std::array<Tile, d*(d + 1) / 2> result;
        std::size_t k = 0;
        for (std::size_t a = 0; a < d; ++a) {
            for (std::size_t b = a; b < d; ++b) {
                const Tile direction = double(d + 2) * p.x_ij[a] * p.x_ij[b] * over_r2;
                result[k++] = (direction - (a == b ? 1.0 : 0.0)) * common;
            }
        }
        return result;
    }
};

/// Particles of the periodic unit box with mass 1/N each, an interpolated quantity A, and density by
/// summation (2.9), sorted for fast sums with the kernel K at smoothing length h.
template <class K>
class Interpolation {
  public:
    static constexpr int d = K::dimension;

    /// `points` in [0, 1)^d, `h` > 0 [box lengths]; A(position) is the quantity to interpolate.
    /// `summed_density`: rho_j = sum m W (2.9), as in SPH; otherwise rho = 1, the exact mean density.
    template <class Function>
    Interpolation(const Columns<d>& points, double h, Function&& A, bool summed_density = true);

    std::size_t size() const noexcept { return n_; }
    double h() const noexcept { return h_; }
    Vector<d> position(std::size_t i) const {
        Vector<d> x{};
        for (std::size_t a = 0; a < d; ++a) x[a] = points_[a][i];
        return x;
    }
    double density(std::size_t i) const { return density_[i]; }
    double value(std::size_t i) const { return value_[i]; }

    /// The listed estimates at particle i, each an array of its components.
    template <class... Estimates>
    auto at(std::size_t i) const {
        return evaluate<Estimates...>(position(i), value_[i], density_[i]);
    }
    /// The listed estimates at any position in the box; A_i and rho_i are used by those that take
    /// differences. Cost: the particles in the cells around the position, 1.1 (1D), 2 (2D) or 6.4 (3D) times
    /// those in the support.
    template <class... Estimates>
    auto evaluate(const Vector<d>& x, double A_i = 0, double rho_i = 1) const;
    /// sum_j m_j W(x - x_j)   (2.9)
    double summed_density_at(const Vector<d>& x) const;
    /// Pairs that evaluate() adds up at particle i, those beyond the support included.
    std::size_t pairs_at(std::size_t i) const;

  private:
    template <class Visit>
    void for_each_tile(const Vector<d>& x, Visit&& visit) const;

    std::size_t n_;
    double h_;
    Columns<d> points_;
    WithImages<d> images_;
    SortedCells<d> cells_;
    Columns<d> x_;                         // sorted, padded to whole tiles
    std::vector<double> m_, V_, A_;        // the same
    std::vector<double> density_, value_;  // in the caller's order
};

template <class K>
template <class Function>
Interpolation<K>::Interpolation(const Columns<d>& points, double h, Function&& A, bool summed_density)
    : n_{points[0].size()},
      h_{h},
      points_{points},
      images_{points, K::support * h},
      cells_{images_.x, K::support * h},
      m_(images_.owner.size() + tile_width, 1.0 / static_cast<double>(n_)),
      density_(n_, 1.0) {
    for (std::size_t a = 0; a < d; ++a) x_[a] = cells_.sorted(images_.x[a], tile_width);
    for (std::size_t i = 0; i < n_; ++i) value_.push_back(A(position(i)));
    if (summed_density) {
        for (std::size_t i = 0; i < n_; ++i) {
            app::check_interrupt();  // Ctrl-C: a million particles take seconds
            density_[i] = summed_density_at(position(i));
        }
    }
    std::vector<double> V, A_images;
    for (const std::size_t i : images_.owner) {
        V.push_back(m_[0] / density_[i]);
        A_images.push_back(value_[i]);
    }
    V_ = cells_.sorted(V, tile_width);
    A_ = cells_.sorted(A_images, tile_width);
}

/// Eight doubles of a column from index j on.
inline Tile load(const std::vector<double>& column, std::size_t j) {
    return Eigen::Map<const Tile>(column.data() + j);
}

/// Zero in the first `used` lanes (1..8) and one in the others: a window on a constant table, one load.
inline Tile unused_lanes(std::size_t used) {
    static constexpr std::array<double, 2 * tile_width> table{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
    return Eigen::Map<const Tile>(table.data() + (tile_width - used));
}

template <class K>
template <class Visit>
void Interpolation<K>::for_each_tile(const Vector<d>& x, Visit&& visit) const {
    const double beyond = 1e6 * square(K::support * h_);
    cells_.for_each_range(x, [&](std::size_t begin, std::size_t end) {
        for (std::size_t j = begin; j < end; j += tile_width) {
            Pairs<d> p;
            // Lanes behind the end of the range are moved beyond the support, where W and F are zero.
            Tile r2 = beyond * unused_lanes(std::min<std::size_t>(end - j, tile_width));
            for (std::size_t a = 0; a < d; ++a) {
                p.x_ij[a] = x[a] - load(x_[a], j);
                r2 += p.x_ij[a] * p.x_ij[a];
            }
            p.r = r2.sqrt();
            visit(p, j);
        }
    });
}

template <class K>
template <class... Estimates>
auto Interpolation<K>::evaluate(const Vector<d>& x, double A_i, double rho_i) const {
    const double h = h_;  // a local: the compiler need not fear that sums overwrite it
    auto sums = std::tuple{decltype(Estimates::template term<d>(std::declval<Pairs<d>>())){}...};
    std::apply(
        [](auto&... sum) { ((std::for_each(sum.begin(), sum.end(), [](Tile& t) { t.setZero(); })), ...); },
        sums);
    for_each_tile(x, [&, h](Pairs<d>& p, std::size_t j) {
        p.A_i = A_i;
        p.rho_i = rho_i;
        p.W = K::W(p.r, h);
        p.F = K::F(p.r, h);
        p.d2W = K::d2W_dr2(p.r, h);
        p.m = load(m_, j);
        p.V = load(V_, j);
        p.A = load(A_, j);
        const auto add = [](auto& sum, const auto& term) {
            for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += term[c];
        };
        std::apply([&](auto&... sum) { (add(sum, Estimates::template term<d>(p)), ...); }, sums);
    });
    const auto total = [](const auto& sum) {
        std::array<double, std::tuple_size_v<std::decay_t<decltype(sum)>>> result;
        for (std::size_t c = 0; c < sum.size(); ++c) result[c] = sum[c].sum();
        return result;
    };
    return std::apply([&](const auto&... sum) { return std::tuple{total(sum)...}; }, sums);
}

template <class K>
double Interpolation<K>::summed_density_at(const Vector<d>& x) const {
    Tile sum = Tile::Zero();
    for_each_tile(x, [&](const Pairs<d>& p, std::size_t) { sum += K::W(p.r, h_); });
    return m_[0] * sum.sum();
}

template <class K>
std::size_t Interpolation<K>::pairs_at(std::size_t i) const {
    std::size_t pairs = 0;
    cells_.for_each_range(position(i), [&](std::size_t begin, std::size_t end) { pairs += end - begin; });
    return pairs;
}

}  // namespace sph
