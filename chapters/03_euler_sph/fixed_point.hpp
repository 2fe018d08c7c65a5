#pragma once
#include <cstdint>

#include "common/core/counters.hpp"
#include "common/core/unstable.hpp"

/// Leapfrog on integers: reversible to the last bit. Rounding is why a trajectory run backwards misses its
/// start; sums of integers are exact, so what one step adds the reversed step takes away.
namespace sph {

/// Drift-kick-drift (Monaghan 2005, 5.42-5.44) with positions and velocities in whole multiples of 2^-52.
/// Positions must stay in (-2048, 2048), accelerations be functions of the positions only, the same bits for
/// the same positions.
class FixedPointLeapfrog {
  public:
    explicit FixedPointLeapfrog(Counters& counters) : counters_{&counters} {}
    template <class P, class Rates>
    void step(P& p, double& t, double dt, Rates&& rates) {
        require_time_step(t, dt);
        if (x_.empty()) start(p);
        drift(dt / 2);
        write(p);
        rates(t + dt / 2);
        std::size_t k = 0;
        for (const Column& a : p.dv_dt) {
            for (const double value : a) v_[k++] += whole(dt * value);
        }
        drift(dt / 2);
        write(p);
        t += dt;
        ++counters_->steps;
        require_physical(p, t, List<Position, Velocity>{});
    }
    /// Rounds the particles' positions and velocities to whole multiples, and goes on from there.
    template <class P>
    void start(P& p) {
        x_.clear();
        v_.clear();
        read(p);
        write(p);
    }
    /// All velocities change sign.
    void reverse() {
        for (std::int64_t& v : v_) v = -v;
    }

  private:
    static constexpr double quantum = 0x1p-52;
    /// To the nearest whole multiple; odd in x, as reversal needs.
    static std::int64_t whole(double x) { return static_cast<std::int64_t>(std::nearbyint(x / quantum)); }

    template <class P>
    void read(const P& p) {
        for (const Column& x : p.x) {
            for (const double value : x) x_.push_back(whole(value));
        }
        for (const Column& v : p.v) {
            for (const double value : v) v_.push_back(whole(value));
        }
    }
    template <class P>
    void write(P& p) const {
        std::size_t k = 0;
        for (std::size_t a = 0; a < p.x.size(); ++a) {
            for (std::size_t i = 0; i < p.size(); ++i, ++k) {
                p.x[a][i] = static_cast<double>(x_[k]) * quantum;
                p.v[a][i] = static_cast<double>(v_[k]) * quantum;
            }
        }
    }
    void drift(double dt) {
        for (std::size_t k = 0; k < x_.size(); ++k)
            x_[k] += whole(dt * (static_cast<double>(v_[k]) * quantum));
    }

    Counters* counters_;
    std::vector<std::int64_t> x_, v_;
};

}  // namespace sph
