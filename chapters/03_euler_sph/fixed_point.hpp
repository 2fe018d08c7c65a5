#pragma once
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "common/core/integrators.hpp"

/// Leapfrog on integers: reversible to the last bit. Rounding is why a trajectory run backwards misses its
/// start; sums of integers are exact, so what one step adds the reversed step takes away.
namespace sph {

/// Drift-kick-drift (Monaghan 2005, 5.42-5.44) with positions and velocities in whole multiples of 2^-52.
/// Positions must stay in (-2048, 2048), accelerations be functions of the positions only, the same bits for
/// the same positions.
template <int d>
class FixedPointLeapfrog : public Integrator {
  public:
    FixedPointLeapfrog(const Motion& motion, Rates rates, Columns<d>& x, Columns<d>& v,
                       const Columns<d>& dv_dt)
        : Integrator{motion, std::move(rates)}, x_{&x}, v_{&v}, dv_dt_{&dv_dt} {}
    /// Takes positions and velocities anew, rounded to whole multiples.
    void restart() override {
        whole_x_ = rounded(*x_);
        whole_v_ = rounded(*v_);
        write();
    }
    /// All velocities change sign.
    void reverse() {
        for (std::int64_t& v : whole_v_) v = -v;
    }

  private:
    static constexpr double quantum = 0x1p-52;
    /// To the nearest whole multiple; odd in x, as reversal needs.
    static std::int64_t whole(double x) { return static_cast<std::int64_t>(std::nearbyint(x / quantum)); }
    static std::vector<std::int64_t> rounded(const Columns<d>& columns) {
        std::vector<std::int64_t> all;
        for (const Column& column : columns) {
            for (const double value : column) all.push_back(whole(value));
        }
        return all;
    }

    void advance(double& t, double dt) override {
        if (whole_x_.empty()) restart();
        drift(dt / 2);
        write();
        rates(t + dt / 2);
        std::size_t k = 0;
        for (const Column& a : *dv_dt_) {
            for (const double value : a) whole_v_[k++] += whole(dt * value);
        }
        drift(dt / 2);
        write();
        t += dt;
    }
    void drift(double dt) {
        for (std::size_t k = 0; k < whole_x_.size(); ++k)
            whole_x_[k] += whole(dt * (static_cast<double>(whole_v_[k]) * quantum));
    }
    void write() const {
        std::size_t k = 0;
        for (std::size_t a = 0; a < d; ++a) {
            for (std::size_t i = 0; i < (*x_)[a].size(); ++i, ++k) {
                (*x_)[a][i] = static_cast<double>(whole_x_[k]) * quantum;
                (*v_)[a][i] = static_cast<double>(whole_v_[k]) * quantum;
            }
        }
    }

    Columns<d>*x_, *v_;
    const Columns<d>* dv_dt_;
    std::vector<std::int64_t> whole_x_, whole_v_;
};

}  // namespace sph
