#include "common/exact/two_layer.hpp"

#include <fmt/format.h>

#include "common/app/error.hpp"
#include "common/exact/program/csv.hpp"
#include "common/exact/program/points.hpp"
#include "common/exact/program/solutions.hpp"

namespace exact::program {
namespace {

class TwoLayerSolution : public Solution {
  public:
    std::string name() const override { return "two-layer"; }
    std::string description() const override {
        return "steady plane flow of two fluids in layers, driven by a wall or a force: y,v,tau";
    }

    void declare(app::CommandLine& command) override {
        const app::Range scale{TwoLayer::least_scale, TwoLayer::largest_scale};
        const app::Range either_way{-TwoLayer::largest_scale, TwoLayer::largest_scale};
        command.number("lower-viscosity", problem_.lower_viscosity, scale, "mass/(length time)",
                       "DYNAMIC viscosity below the interface");
        command.number("upper-viscosity", problem_.upper_viscosity, scale, "mass/(length time)",
                       "DYNAMIC viscosity above it");
        command.number("interface", problem_.interface, {0, 1, true, true}, "height", "where it lies");
        command.number("height", problem_.height, scale, "length", "between the walls");
        command.number("speed", problem_.speed, either_way, "length/time", "of the upper wall");
        command.number("force", problem_.force, either_way, "mass/(length^2 time^2)",
                       "by volume, which drives both fluids");
        points_.declare(command, "positions between the walls");
        command.footer("Example: exact two-layer --upper-viscosity 10 --points 101 --window 0,1");
    }

    std::string csv(const app::CommandLine& command) const override {
        const auto points = points_.values(command);
        for (const double y : points) require_place(command, y);
        const TwoLayer solution{problem_};
        Csv csv;
        csv.parameter("lower_viscosity", problem_.lower_viscosity);
        csv.parameter("upper_viscosity", problem_.upper_viscosity);
        csv.parameter("interface", problem_.interface).parameter("height", problem_.height);
        csv.parameter("speed", problem_.speed).parameter("force", problem_.force);
        csv.parameter("interface_speed", solution.at(problem_.interface * problem_.height).v);
        csv.columns("y,v,tau");
        for (const double y : points) {
            const auto [v, tau] = solution.at(y);
            csv.row({y, v, tau});
        }
        return csv.text();
    }

  private:
    void require_place(const app::CommandLine& command, double y) const {
        if (y >= 0 && y <= problem_.height) return;
        throw app::UsageError{fmt::format("--{}: {} is not allowed; allowed: 0..{}, between the walls",
                                          command.given("y") ? "y" : "window", y, problem_.height)};
    }

    TwoLayer::Problem problem_;
    Points points_{"y", app::any, {0, 1}};
};

}  // namespace

std::unique_ptr<Solution> two_layer() {
    return std::make_unique<TwoLayerSolution>();
}

}  // namespace exact::program
