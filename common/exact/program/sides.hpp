#pragma once
#include <functional>
#include <string>
#include <vector>

#include "common/app/command_line.hpp"

namespace exact::program {

/// The two states of a Riemann problem: `--left rho,v,p` at x < 0 and `--right rho,v,p` at x > 0; the density
/// 0 is a vacuum.
class Sides {
  public:
    struct Limits {
        double largest;           ///< of all magnitudes
        double least_density{0};  ///< of a gas
        app::Range velocity{};
    };
    /// `left` and `right`, the defaults: three numbers each.
    Sides(std::vector<double> left, std::vector<double> right, Limits limits);

    void declare(app::CommandLine& command);

    /// Throws app::UsageError, which names the option and the value, unless both sides are gas within the
    /// limits with pressures of 0 and above, or one of them is a vacuum: density and pressure are 0.
    void check() const;

    /// Replaces the velocities, which were told in another way, by what `velocity` makes of them. Throws
    /// app::UsageError naming the option if it throws std::domain_error.
    void convert(const std::function<double(double)>& velocity);

    template <class State>
    State left() const {
        return {left_[0], left_[1], left_[2]};
    }
    template <class State>
    State right() const {
        return {right_[0], right_[1], right_[2]};
    }

  private:
    void check(const std::string& option, const std::vector<double>& values) const;

    std::vector<double> left_, right_;
    Limits limits_;
};

}  // namespace exact::program
