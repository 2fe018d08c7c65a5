#include "common/exact/noh.hpp"

#include <fmt/format.h>

#include "common/app/error.hpp"
#include "common/exact/program/csv.hpp"
#include "common/exact/program/points.hpp"
#include "common/exact/program/solutions.hpp"

namespace exact::program {
namespace {

class NohSolution : public Solution {
  public:
    std::string name() const override { return "noh"; }
    std::string description() const override {
        return "the Noh problem, cold gas that rushes to a plane, an axis or a point: x,rho,v,p,u";
    }

    void declare(app::CommandLine& command) override {
        const app::Range scale{Noh::least_scale, Noh::largest_scale};
        command.integer("dimension", dimension_, 1, 3, "of space: 1 to a plane, 2 to an axis, 3 to a point");
        command.number("gamma", gamma_, {1, Noh::largest_gamma, true}, "", "adiabatic index");
        command.number("density", density_, scale, "mass/length^dimension", "density at t = 0");
        command.number("speed", speed_, scale, "length/time", "speed towards x = 0 at t = 0");
        command.number("time", time_, {0, Noh::largest_scale}, "time", "since the gas began to move");
        points_.declare(command, "positions; for dimensions 2 and 3 distances from the centre, 0 and above");
        command.footer("Example: exact noh --dimension 2 --time 0.6 --points 101 --window 0,0.5");
    }

    std::string csv(const app::CommandLine& command) const override {
        const auto points = points_.values(command);
        for (const double x : points) require_place(command, x);
        const Noh solution{static_cast<int>(dimension_), gamma_, density_, speed_};
        const Noh::State post = solution.post_shock();
        Csv csv;
        csv.parameter("dimension", static_cast<double>(dimension_)).parameter("gamma", gamma_);
        csv.parameter("density", density_).parameter("speed", speed_).parameter("time", time_);
        csv.parameter("shock_position", solution.shock_position(time_));
        csv.parameter("shock_speed", solution.shock_speed()).parameter("rho_post", post.rho);
        csv.parameter("p_post", post.p).parameter("u_post", post.u).columns("x,rho,v,p,u");
        for (const double x : points) {
            const auto [rho, v, p, u] = solution.at(x, time_);
            csv.row({x, rho, v, p, u});
        }
        return csv.text();
    }

  private:
    void require_place(const app::CommandLine& command, double x) const {
        if (x >= 0 || dimension_ == 1) return;
        throw app::UsageError{
            fmt::format("--{}: {} is not allowed; allowed: distances, 0 and above, for "
                        "--dimension {}",
                        command.given("x") ? "x" : "window", x, dimension_)};
    }

    long dimension_ = 3;
    double gamma_ = 5.0 / 3, density_ = 1, speed_ = 1, time_ = 0.6;
    Points points_{"x", app::any, {0, 1}};
};

}  // namespace

std::unique_ptr<Solution> noh() {
    return std::make_unique<NohSolution>();
}

}  // namespace exact::program
