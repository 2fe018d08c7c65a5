#pragma once

namespace exact::relativistic_waves {

using Real = long double;

/// One side of the relativistic Riemann problem as if it were the left one, and the waves that run into it.
/// The equations are those of exact::RelativisticRiemann, in forms without differences of nearly equal terms.
struct Side {
    /// rho, p and gamma as there; the rapidity has the opposite sign on the right side.
    Side(Real density, Real rapidity_inwards, Real pressure, Real adiabatic_index);

    /// What a wave has made of the gas.
    struct Behind {
        Real push;        ///< f_K: how much rapidity the gas has lost; < 0 in a rarefaction
        Real slope;       ///< d push/d ln p
        Real rho, w;      ///< density, and h - 1
        Real shock_sinh;  ///< sinh of the shock's rapidity, 0 of a rarefaction
        bool shock;
    };
    /// A state in a fan.
    struct Inside {
        Real rho, rapidity, p, w;
    };

    bool empty() const { return rho == 0; }
    /// Behind the wave that leads to the pressure p_star > 0, z = ln(p_star/p): infinite for cold gas.
    Behind behind(Real z, Real p_star) const { return z > 0 ? shock(z, p_star) : rarefaction(z); }
    /// F: the rapidity that the gas gains when it expands into vacuum.
    Real expansion() const;
    /// The wave's edges beside the gas ahead and behind.
    Real head(const Behind& wave) const;
    Real tail(const Behind& wave) const;
    /// artanh c_s of gas whose enthalpy is 1 + w_of_gas.
    Real sound(Real w_of_gas) const;
    /// In the fan, at the distance `width` >= 0 of rapidity from its head.
    Inside fan(Real width) const;

    Real rho, rapidity, p, gamma;
    Real k;      ///< sqrt(gamma - 1)
    Real theta;  ///< p/rho
    Real w;      ///< h - 1 = gamma/(gamma-1) p/rho

  private:
    Behind rarefaction(Real z) const;
    Behind shock(Real z, Real p_star) const;
};

}  // namespace exact::relativistic_waves
