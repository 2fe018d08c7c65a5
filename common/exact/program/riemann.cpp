#include "common/exact/riemann.hpp"

#include "common/exact/program/csv.hpp"
#include "common/exact/program/points.hpp"
#include "common/exact/program/sides.hpp"
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
        sides_.declare(command);
        command.number("gamma", gamma_, {1, Riemann::largest_gamma, true}, "", "adiabatic index");
        command.number("time", time_, app::non_negative, "time", "0: the initial states");
        points_.declare(command, "positions");
        command.footer(
            "Example: exact riemann --left 1,0,1 --right 0.125,0,0.1 --gamma 1.4 --time 0.2 "
            "--points 201 --window -0.5,0.5");
    }

    std::string csv(const app::CommandLine& command) const override {
        const auto points = points_.values(command);
        sides_.check();
        const Riemann solution{sides_.left<Riemann::State>(), sides_.right<Riemann::State>(), gamma_};
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
    Sides sides_{{1, 0, 1}, {0.125, 0, 0.1}, {Riemann::largest_scale}};
    double gamma_ = 1.4, time_ = 0.2;
    Points points_{"x", app::any, {-0.5, 0.5}};
};

}  // namespace

std::unique_ptr<Solution> riemann() {
    return std::make_unique<RiemannSolution>();
}

}  // namespace exact::program
