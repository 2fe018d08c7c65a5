#include "common/exact/gresho.hpp"

#include "common/exact/program/csv.hpp"
#include "common/exact/program/points.hpp"
#include "common/exact/program/solutions.hpp"

namespace exact::program {
namespace {

class GreshoSolution : public Solution {
  public:
    std::string name() const override { return "gresho"; }
    std::string description() const override {
        return "Gresho's vortex, a flow in circles that its own pressure holds: r,v,p";
    }

    void declare(app::CommandLine& command) override {
        const app::Range scale{Gresho::least_scale, Gresho::largest_scale};
        command.number("speed", speed_, scale, "length/time", "the largest velocity");
        command.number("radius", radius_, scale, "length", "where the fluid has it");
        command.number("density", density_, scale, "mass/length^2", "everywhere");
        command.number("pressure", pressure_, {0, Gresho::largest_scale}, "mass/time^2", "at the centre");
        points_.declare(command, "distances from the centre");
        command.footer("Example: exact gresho --pressure 5 --points 101 --window 0,0.5");
    }

    std::string csv(const app::CommandLine& command) const override {
        const Gresho vortex{speed_, radius_, density_, pressure_};
        Csv csv;
        csv.parameter("speed", speed_).parameter("radius", radius_).parameter("density", density_);
        csv.parameter("pressure", pressure_).columns("r,v,p");
        for (const double r : points_.values(command)) {
            const auto [v, p] = vortex.at(r);
            csv.row({r, v, p});
        }
        return csv.text();
    }

  private:
    double speed_ = 1, radius_ = 0.2, density_ = 1, pressure_ = 5;
    Points points_{"r", app::non_negative, {0, 0.5}};
};

}  // namespace

std::unique_ptr<Solution> gresho() {
    return std::make_unique<GreshoSolution>();
}

}  // namespace exact::program
