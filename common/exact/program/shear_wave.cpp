#include "common/exact/shear_wave.hpp"

#include "common/exact/program/csv.hpp"
#include "common/exact/program/points.hpp"
#include "common/exact/program/solutions.hpp"

namespace exact::program {
namespace {

class ShearWaveSolution : public Solution {
  public:
    std::string name() const override { return "shear-wave"; }
    std::string description() const override {
        return "a periodic shear wave v_y(x, t) that viscosity damps: x,v_y";
    }

    void declare(app::CommandLine& command) override {
        const app::Range scale{ShearWave::least_scale, ShearWave::largest_scale};
        command.number("viscosity", viscosity_, {0, ShearWave::largest_scale}, "length^2/time",
                       "KINEMATIC viscosity");
        command.number("speed", speed_, scale, "length/time", "largest velocity at t = 0");
        command.number("side", side_, scale, "length", "the period");
        command.integer("mode", mode_, 1, ShearWave::largest_mode, "waves in a side");
        command.number("time", time_, {0, ShearWave::largest_scale}, "time", "since the start");
        points_.declare(command, "positions");
        command.footer("Example: exact shear-wave --viscosity 0.01 --time 1 --points 101 --window 0,1");
    }

    std::string csv(const app::CommandLine& command) const override {
        const auto points = points_.values(command);
        const ShearWave solution{viscosity_, speed_, side_, static_cast<int>(mode_)};
        Csv csv;
        csv.parameter("viscosity", viscosity_).parameter("speed", speed_).parameter("side", side_);
        csv.parameter("mode", static_cast<double>(mode_)).parameter("time", time_);
        csv.parameter("decay_rate", solution.decay_rate()).columns("x,v_y");
        for (const double x : points) csv.row({x, solution.velocity(x, time_)});
        return csv.text();
    }

  private:
    double viscosity_ = 0.01, speed_ = 1, side_ = 1, time_ = 0;
    long mode_ = 1;
    Points points_{"x", app::any, {0, 1}};
};

}  // namespace

std::unique_ptr<Solution> shear_wave() {
    return std::make_unique<ShearWaveSolution>();
}

}  // namespace exact::program
