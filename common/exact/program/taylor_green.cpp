#include "common/exact/taylor_green.hpp"

#include "common/exact/program/csv.hpp"
#include "common/exact/program/solutions.hpp"

namespace exact::program {
namespace {

class TaylorGreenSolution : public Solution {
  public:
    std::string name() const override { return "taylor-green"; }
    std::string description() const override {
        return "decaying Taylor-Green vortices of an incompressible fluid in a periodic square: "
               "x,y,v_x,v_y,p";
    }

    void declare(app::CommandLine& command) override {
        const app::Range scale{TaylorGreen::least_scale, TaylorGreen::largest_scale};
        command.number("viscosity", viscosity_, {0, TaylorGreen::largest_scale}, "length^2/time",
                       "KINEMATIC viscosity");
        command.number("speed", speed_, scale, "length/time", "largest velocity at t = 0");
        command.number("side", side_, scale, "length", "of the square");
        command.number("density", density_, scale, "mass/length^2", "of the fluid");
        command.number("time", time_, {0, TaylorGreen::largest_scale}, "time", "since the start");
        command.integer("points", count_, 1, 1000, "N of a grid of N x N points, x and y = 0, side/N, ...");
        command.footer("Example: exact taylor-green --viscosity 0.01 --time 1 --points 50");
    }

    std::string csv(const app::CommandLine&) const override {
        const TaylorGreen solution{viscosity_, speed_, side_, density_};
        Csv csv;
        csv.parameter("viscosity", viscosity_).parameter("speed", speed_).parameter("side", side_);
        csv.parameter("density", density_).parameter("time", time_);
        csv.parameter("decay_rate", solution.decay_rate());
        csv.parameter("kinetic_energy", solution.kinetic_energy(time_)).columns("x,y,v_x,v_y,p");
        const auto place = [&](long k) {
            return side_ * static_cast<double>(k) / static_cast<double>(count_);
        };
        for (long row = 0; row < count_; ++row) {
            for (long column = 0; column < count_; ++column) {
                const double x = place(column), y = place(row);
                const auto [v_x, v_y, p] = solution.at(x, y, time_);
                csv.row({x, y, v_x, v_y, p});
            }
        }
        return csv.text();
    }

  private:
    double viscosity_ = 0.01, speed_ = 1, side_ = 1, density_ = 1, time_ = 0;
    long count_ = 50;
};

}  // namespace

std::unique_ptr<Solution> taylor_green() {
    return std::make_unique<TaylorGreenSolution>();
}

}  // namespace exact::program
