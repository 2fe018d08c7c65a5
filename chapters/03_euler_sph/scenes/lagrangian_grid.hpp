#pragma once
#include <cstddef>
#include <vector>

#include "common/core/stepper.hpp"

/// The competitor in one dimension: a second-order Lagrangian grid without viscosity (von Neumann & Richtmyer
/// 1950, with their viscosity left out). Cells hold mass, their faces move; no kernel, no neighbours to find.
namespace sph::euler {

/// dv_f/dt = -(P_right - P_left)/m_f - Omega^2 x_f, rho = m/(x_{f+1} - x_f), by leapfrog.
template <class State>
class LagrangianGrid : public Stepper {
  public:
    std::vector<double> x, v;  ///< of the faces: one more than cells; periodic: as many
    std::vector<double> m;     ///< of the cells, between faces k and k + 1

    /// `period` > 0: the length of a periodic domain; 0: vacuum outside. Omega >= 0: of the linear force.
    LagrangianGrid(State state, double period, double Omega)
        : state_{state}, period_{period}, Omega_{Omega} {}

    double density(std::size_t cell) const {
        const bool last = cell + 1 == x.size();
        return m[cell] / ((last ? x[0] + period_ : x[cell + 1]) - x[cell]);
    }
    /// One step of kick-drift-kick. Cost: an equation of state a cell.
    bool step(double& t, double dt) override {
        if (a_.empty()) accelerate();
        advance(v, a_, dt / 2);
        advance(x, v, dt);
        accelerate();
        advance(v, a_, dt / 2);
        t += dt;
        return true;
    }

  private:
    static void advance(std::vector<double>& value, const std::vector<double>& rate, double dt) {
        for (std::size_t k = 0; k < value.size(); ++k) value[k] += dt * rate[k];
    }
    void accelerate() {
        const std::size_t cells = m.size(), faces = x.size();
        p_.resize(cells);
        a_.resize(faces);
        for (std::size_t k = 0; k < cells; ++k) p_[k] = state_.pressure(density(k));
        for (std::size_t f = 0; f < faces; ++f) {
            const bool closed = faces == cells;  // periodic
            const bool has_left = closed || f > 0, has_right = closed || f < cells;
            const std::size_t left = f > 0 ? f - 1 : cells - 1, right = f < cells ? f : 0;
            const double m_f = 0.5 * ((has_left ? m[left] : 0) + (has_right ? m[right] : 0));
            a_[f] = ((has_left ? p_[left] : 0) - (has_right ? p_[right] : 0)) / m_f - Omega_ * Omega_ * x[f];
        }
    }

    State state_;
    double period_, Omega_;
    std::vector<double> p_, a_;
};

}  // namespace sph::euler
