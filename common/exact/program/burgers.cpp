#include "common/exact/burgers.hpp"

#include "common/exact/program/csv.hpp"
#include "common/exact/program/points.hpp"
#include "common/exact/program/solutions.hpp"

namespace exact::program {
namespace {

class BurgersSolution : public Solution {
  public:
    std::string name() const override { return "burgers"; }
    std::string description() const override {
        return "Burgers' equation u_t + u u_x = nu u_xx from u = sin(pi x) (Cole-Hopf): x,u";
    }

    void declare(app::CommandLine& command) override {
        command.number("viscosity", viscosity_, {Burgers::least_viscosity, Burgers::largest_viscosity}, "",
                       "kinematic viscosity nu, in units of amplitude times half period of the initial wave");
        command.number("time", time_, {0, Burgers::largest_time}, "",
                       "time, in units of half period over amplitude");
        points_.declare(command, "positions in units of the half period");
        command.footer("Example: exact burgers --viscosity 0.01 --time 0.5 --points 101 --window 0,1");
    }

    std::string csv(const app::CommandLine& command) const override {
        const auto points = points_.values(command);
        const Burgers solution{viscosity_};
        Csv csv;
        csv.parameter("viscosity", viscosity_).parameter("time", time_).columns("x,u");
        for (const double x : points) csv.row({x, solution.velocity(x, time_)});
        return csv.text();
    }

  private:
    double viscosity_ = 0.01;
    double time_ = 0.5;
    Points points_{"x", app::any, {0, 1}};
};

}  // namespace

std::unique_ptr<Solution> burgers() {
    return std::make_unique<BurgersSolution>();
}

}  // namespace exact::program
