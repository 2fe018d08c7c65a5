#include "common/exact/riemann.hpp"

#include "common/app/error.hpp"
#include "common/exact/program/csv.hpp"
#include "common/exact/program/points.hpp"
#include "common/exact/program/solutions.hpp"

namespace exact::program {
namespace {

class RiemannSolution : public Solution {
  public:
    std::string name() const override { return "riemann"; }
    std::string description() const override {
        return "the Riemann problem of an ideal gas, vacuum included: x,rho,v,p,u";
    }

    void declare(app::CommandLine& command) override {
        const app::Range scale{-Riemann::largest_scale, Riemann::largest_scale};
        command.numbers("left", left_, scale, "", "density, velocity and pressure at x < 0", 3);
        command.numbers("right", right_, scale, "", "density, velocity and pressure at x > 0", 3);
        command.number("gamma", gamma_, {1, Riemann::largest_gamma, true}, "", "adiabatic index");
        command.number("time", time_, app::non_negative, "time", "0: the initial states");
        points_.declare(command, "positions");
        command.footer(
            "Example: exact riemann --left 1,0,1 --right 0.125,0,0.1 --gamma 1.4 --time 0.2 "
            "--points 201 --window -0.5,0.5");
    }

    std::string csv(const app::CommandLine& command) const override {
        const auto points = points_.values(command);
        const Riemann solution{state("left", left_), state("right", right_), gamma_};
        const Riemann::Star& star = solution.star();
        Csv csv;
        csv.parameter("gamma", gamma_).parameter("time", time_);
        csv.parameter("p_star", star.p).parameter("v_star", star.v);
        csv.parameter("rho_star_left", star.rho_left).parameter("rho_star_right", star.rho_right);
        csv.columns("x,rho,v,p,u");
        for (const double x : points) {
            const auto [rho, v, p, u] = solution.at(x, time_);
            csv.row({x, rho, v, p, u});
        }
        return csv.text();
    }

  private:
    Riemann::State state(const std::string& side, const std::vector<double>& values) const {
        const Riemann::State state{values[0], values[1], values[2]};
        if (state.rho < 0 || state.p < 0)
            throw app::UsageError{"--" + side +
                                  ": density and pressure below 0 are not allowed; allowed: 0 and above"};
        if (state.rho == 0 && state.p > 0)
            throw app::UsageError{"--" + side +
                                  ": pressure in a vacuum is not allowed; allowed: 0 where the density is 0"};
        if (left_[0] == 0 && right_[0] == 0)
            throw app::UsageError{"--" + side + ": vacuum on both sides is not allowed; allowed: on one"};
        return state;
    }

    std::vector<double> left_{1, 0, 1}, right_{0.125, 0, 0.1};
    double gamma_ = 1.4, time_ = 0.2;
    Points points_{"x", app::any, {-0.5, 0.5}};
};

}  // namespace

std::unique_ptr<Solution> riemann() {
    return std::make_unique<RiemannSolution>();
}

}  // namespace exact::program
