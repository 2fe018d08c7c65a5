#pragma once

namespace exact {

/// Of plates that are bent: whether the third axis is kept from stretching (a wide plate) or free of stress
/// (a narrow beam).
enum class Plane { strain, stress };

/// Resistance to bending of a plate, E' H^3/12 for a depth of one, with E' = E/(1 - nu^2) in plane strain and
/// E in plane stress (Landau & Lifshitz, Theory of Elasticity (1986), eqs 11.5 and 17.4).
/// thickness H > 0 [length], young E > 0 [pressure], poisson nu in (-1, 0.5]. Returns [pressure length^3].
/// Throws std::domain_error, which names the value, outside these ranges.
double bending_stiffness(double thickness, double young, double poisson, Plane plane = Plane::strain);

/// A thin plate that is clamped at x = 0 and free at x = L swings in modes y = phi(x) cos(omega t),
///     omega = (kL/L)^2 sqrt(D/(rho H)),   cos kL cosh kL = -1,
///     phi(x) = cosh kx - cos kx - s (sinh kx - sin kx),   s = (sinh kL - sin kL)/(cosh kL + cos kL)
/// (Landau & Lifshitz, section 25, problem 5), with the stiffness D of bending_stiffness(). Thin: shear and
/// the inertia of rotation are left out, which lower the frequencies by some (H/L)^2.
class ClampedPlate {
  public:
    static constexpr double least_scale = 1e-50, largest_scale = 1e50;
    static constexpr int largest_mode = 1000, largest_shape = 5;

    /// thickness H, length L [length], young E [pressure], density rho [mass/length^3]: least_scale..
    /// largest_scale; poisson nu in (-1, 0.5]. Throws std::domain_error, which names the value, elsewhere.
    ClampedPlate(double thickness, double length, double young, double poisson, double density,
                 Plane plane = Plane::strain);

    /// The n-th solution kL of cos kL cosh kL = -1, n = mode in 1..largest_mode; to rounding.
    static double wave_number(int mode);
    double omega(int mode) const;  ///< [1/time]; mode in 1..largest_mode
    /// phi(x) at 0 <= x <= L, for modes 1..largest_shape; phi(L) = 2 or -2. Digits are lost like e^kL: 1e-9
    /// at the fifth mode. Throws std::domain_error outside.
    double shape(int mode, double x) const;

  private:
    double length_, frequency_;  // sqrt(D/(rho H))/L^2
};

/// A beam that is clamped at x = 0 and carries the force w at x = L bends by
///     y = w x^2 (3 L - x)/(6 D),   y(L) = w L^3/(3 D)
/// (Landau & Lifshitz, section 20, problem 3; D = E' I for a depth of one).
class LoadedBeam {
  public:
    /// thickness, length, young, poisson as above; load w in +-largest_scale [pressure length: force by
    /// depth]. Throws std::domain_error, which names the value, elsewhere.
    LoadedBeam(double thickness, double length, double young, double poisson, double load,
               Plane plane = Plane::strain);
    /// y at 0 <= x <= L; throws std::domain_error elsewhere.
    double deflection(double x) const;
    double stiffness() const { return stiffness_; }  ///< D

  private:
    double length_, load_, stiffness_;
};

}  // namespace exact
