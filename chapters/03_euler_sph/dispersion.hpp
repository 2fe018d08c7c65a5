#pragma once
#include <cmath>
#include <initializer_list>

/// Sound on an even line of particles: the exact dispersion relation of the SPH equations (Monaghan 2005,
/// section 6.1, corrected), by sums over the lattice.
namespace sph {

/// The density by summation of an even line of particles of spacing and mass 1; h in spacings.
template <class K>
double lattice_density(double h) {
    double rho = 0;
    const int last = static_cast<int>(std::ceil(K::support * h));
    for (int c = -last; c <= last; ++c) rho += K::W(std::abs(double(c)), h);
    return rho;
}

/// S = (h/rho) sum_c m_c dW/dh on the same line (Monaghan 2005, 5.11): in one dimension Omega = 1 + S (5.7),
/// and the slope of ln rho with ln h.
template <class K>
double lattice_slope(double h) {
    double sum = 0;
    const int last = static_cast<int>(std::ceil(K::support * h));
    for (int c = -last; c <= last; ++c) {
        const double r = std::abs(double(c));
        sum -= K::W(r, h) + r * r * K::F(r, h);  // h dW/dh
    }
    return sum / lattice_density<K>(h);
}

/// omega^2 at wave number k, in units where the spacing and the speed of sound are 1.
struct Dispersion {
    double fixed_h;        ///< one h for all
    double variable_h;     ///< h in proportion to 1/rho, with all terms of the Lagrangian
    double without_omega;  ///< the same h, the force (3.8) without the terms of its variation
};

/// Both of (6.2) and of its limit for a constant h, for the kernel K with h in spacings, P = K rho^gamma:
///     omega^2 = c_s^2/(gamma Omega) [(gamma - 2) Phi^2/Omega + 2 Psi - h/Omega dPhi^2/dh - l Phi^2/Omega^2]
/// with Omega in the first denominators (our copy prints omega), the second derivative of W in Psi with
/// respect to x (printed: h), and c_s, Omega at the density that the lattice has by summation. Without Omega
/// in the force, by the same steps,
///     omega^2 = c_s^2/gamma [(gamma - 2) Phi^2/Omega + 2 Psi - h Phi dPhi/dh / Omega].
/// For long waves, W^ = 1 - b h^2 k^2, the three are k^2 [1 + 2 b h^2 k^2 (n - gamma)/gamma] with n = 1,
/// 3, 2. h > 0 [spacings], gamma >= 1, k [1/spacing]. Cost: 2 support h terms. For every k; (6.6)-(6.13) are
/// limits.
template <class K>
Dispersion dispersion(double h, double gamma, double k) {
    // With W = W(x, h) in one dimension: dW/dh = -(W + x W')/h, and so on.
    double rho = 0, Phi = 0, Phi_h = 0, Psi = 0, W_h = 0, W_hh = 0;
    const int last = static_cast<int>(std::ceil(K::support * h));
    for (int c = -last; c <= last; ++c) {
        const double x = c, r = std::abs(x);
        const double W = K::W(r, h), W_x = x * K::F(r, h), W_xx = K::d2W_dr2(r, h);
        rho += W;
        Phi += std::sin(k * x) * W_x;
        Phi_h -= std::sin(k * x) * (2 * W_x + x * W_xx) / h;
        Psi += (1 - std::cos(k * x)) * W_xx;
        W_h -= (W + x * W_x) / h;
        W_hh += (2 * W + 4 * x * W_x + x * x * W_xx) / (h * h);
    }
    for (double* sum : {&Phi, &Phi_h, &Psi, &W_h, &W_hh}) *sum /= rho;  // the volume m/rho of a particle
    const double Omega = 1 + h * W_h, l = -2 * h * W_h - h * h * W_hh;
    return {((gamma - 2) * Phi * Phi + 2 * Psi) / gamma,
            ((gamma - 2) * Phi * Phi / Omega + 2 * Psi - h / Omega * 2 * Phi * Phi_h -
             l * Phi * Phi / (Omega * Omega)) /
                (gamma * Omega),
            ((gamma - 2) * Phi * Phi / Omega + 2 * Psi - h / Omega * Phi * Phi_h) / gamma};
}

}  // namespace sph
