#pragma once
#include "chapters/06_finite_particle_method/neighbourhood.hpp"

/// The sums of chapter 1 as rows of coefficients, nothing solved: where the family starts.
namespace sph {

enum class Second {
    twice,     ///< the first derivative of the first derivative (Ye et al. 2019, 7)
    brookshaw  ///< 2 sum V (f_i - f_j) F, 1D (Brookshaw 1985; chapter 1)
};

/// rho_i = sum_j m_j W_ij                                     (Ye et al. 2019, 6)
/// value   f_i   = sum_j V_j f_j W_ij                         (Ye et al. 2019, 5)
/// slope   f_i,x = 1/rho_i sum_j m_j (f_j - f_i) grad_i W_ij  (Ye et al. 2019, 7)
template <int d>
class PlainSums final : public Estimator<d> {
  public:
    explicit PlainSums(Second second) : second_{second} {}
    bool needs_volumes() const override { return true; }
    bool has_second() const override { return second_ == Second::brookshaw; }

    double coefficients(const Neighbourhood<d>& near, const AnyKernel<d>& kernel,
                        Coefficients<d>& out) const override {
        double rho = 0;
        for (std::size_t t = 0; t < near.tiles(); ++t) {
            const Vec<Tile, d> x_ji = near.x_ji(t);
            const Tile r = dot(x_ji, x_ji).sqrt(), W = kernel.W(r, near.h), F = kernel.F(r, near.h);
            rho += (near.m(t) * W).sum();
            const std::size_t at = t * tile_width;
            (near.V(t) * W).store(out.of(0) + at);
            for (std::size_t a = 0; a < d; ++a) (-(near.m(t) * x_ji[a] * F)).store(out.of(1 + a) + at);
            if (has_second()) (-2.0 * near.V(t) * F).store(out.of(1 + d) + at);
        }
        for (std::size_t k = 1; k <= (has_second() ? 1 + d : d); ++k) {
            double sum = 0;
            for (std::size_t j = 0; j < near.count; ++j) {
                if (k <= d) out.of(k)[j] /= rho;
                sum += out.of(k)[j];
            }
            if (near.self != Neighbourhood<d>::nobody) out.of(k)[near.self] -= sum;
        }
        return 1;
    }

  private:
    Second second_;
};

}  // namespace sph
