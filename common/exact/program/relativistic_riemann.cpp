#include "common/exact/relativistic_riemann.hpp"

#include <cmath>

#include "common/exact/lorentz.hpp"
#include "common/exact/program/csv.hpp"
#include "common/exact/program/points.hpp"
#include "common/exact/program/sides.hpp"
#include "common/exact/program/solutions.hpp"

namespace exact::program {
namespace {

/// The defaults are problem 1 of Marti and Mueller, with a pressure of 13.33 (not 40/3, which changes the
/// fourth digit of p_star), and of 1e-8 instead of 0 on the right.
class RelativisticRiemannSolution : public Solution {
  public:
    std::string name() const override { return "relativistic-riemann"; }
    std::string description() const override {
        return "the Riemann problem of relativistic gas, cold gas and vacuum included: x,rho,v,p,u,lorentz";
    }

    void declare(app::CommandLine& command) override {
        sides_.declare(command);
        std::vector<std::string> names;
        for (const auto& [name, make] : relativistic::velocities()) names.push_back(name);
        command.choice("velocity", velocity_, names,
                       "how those of --left and --right are told; a Lorentz factor has the sign of v");
        command.number("gamma", gamma_, {1, 2, true}, "", "adiabatic index");
        command.number("time", time_, app::non_negative, "time", "0: the initial states");
        points_.declare(command, "positions");
        command.footer(
            "Densities and pressures are those of the gas at rest; velocities lie between -1 and 1.\n"
            "Columns: u is the specific energy p/((gamma - 1) rho), lorentz the factor 1/sqrt(1 - v^2).\n"
            "Example: exact relativistic-riemann --left 1,0,1000 --right 1,0,0.01 --time 0.35 "
            "--points 201 --window -0.5,0.5");
    }

    std::string csv(const app::CommandLine& command) const override {
        const auto points = points_.values(command);
        Sides sides = sides_;
        sides.convert(relativistic::velocities().at(velocity_));
        sides.check();
        using State = RelativisticRiemann::State;
        const RelativisticRiemann solution{sides.left<State>(), sides.right<State>(), gamma_};
        const RelativisticRiemann::Star& star = solution.star();
        Csv csv;
        csv.parameter("gamma", gamma_).parameter("time", time_);
        csv.parameter("p_star", star.p).parameter("v_star", star.v);
        csv.parameter("rho_star_left", star.rho_left).parameter("rho_star_right", star.rho_right);
        csv.columns("x,rho,v,p,u,lorentz");
        for (const double x : points) {
            const RelativisticRiemann::Point at = solution.at(x, time_);
            csv.row({x, at.rho, at.v, at.p, at.u, std::cosh(at.rapidity)});
        }
        return csv.text();
    }

  private:
    Sides sides_{
        {10, 0, 13.33},
        {1, 0, 1e-8},
        {RelativisticRiemann::largest_scale, RelativisticRiemann::least_density, {-1, 1, true, true}}};
    std::string velocity_ = "v";
    double gamma_ = 5.0 / 3, time_ = 0.4;
    Points points_{"x", app::any, {-0.5, 0.5}};
};

}  // namespace

std::unique_ptr<Solution> relativistic_riemann() {
    return std::make_unique<RelativisticRiemannSolution>();
}

}  // namespace exact::program
