#include "common/exact/rarefaction.hpp"

#include <fmt/format.h>

#include "common/app/error.hpp"
#include "common/exact/program/csv.hpp"
#include "common/exact/program/points.hpp"
#include "common/exact/program/solutions.hpp"

namespace exact::program {
namespace {

class RarefactionSolution : public Solution {
  public:
    std::string name() const override { return "rarefaction"; }
    std::string description() const override {
        return "Gas at rest in |x| < half width that expands into the vacuum, until its two rarefactions "
               "meet: "
               "x,rho,v,p,u";
    }

    void declare(app::CommandLine& command) override {
        const app::Range scale{Rarefaction::least_scale, Rarefaction::largest_scale};
        command.number("rho", rho_, scale, "mass/length", "density at t = 0");
        command.number("u", u_, scale, "length^2/time^2", "specific thermal energy at t = 0");
        command.number("gamma", gamma_, {1, Rarefaction::largest_gamma, true}, "", "adiabatic index");
        command.number("half-width", half_width_, scale, "length", "the gas fills |x| < half width at t = 0");
        command.number("time", time_, app::non_negative, "time",
                       "up to half width over speed of sound, when the rarefactions meet");
        points_.declare(command, "positions");
        command.footer("Example: exact rarefaction --time 0.1 --points 101 --window -1.5,1.5");
    }

    std::string csv(const app::CommandLine& command) const override {
        const auto points = points_.values(command);
        const Rarefaction solution{rho_, u_, gamma_, half_width_};
        if (time_ > solution.meeting_time())
            throw app::UsageError{
                fmt::format("--time: {} is not allowed; allowed: 0..{} (half width over speed "
                            "of sound, when the rarefactions meet)",
                            time_, solution.meeting_time())};
        Csv csv;
        csv.parameter("rho", rho_).parameter("u", u_).parameter("gamma", gamma_);
        csv.parameter("half_width", half_width_).parameter("time", time_);
        csv.parameter("c0", solution.sound_speed()).parameter("head", solution.head(time_));
        csv.parameter("front", solution.front(time_)).columns("x,rho,v,p,u");
        for (const double x : points) {
            const auto [rho, v, p, u] = solution.at(x, time_);
            csv.row({x, rho, v, p, u});
        }
        return csv.text();
    }

  private:
    double rho_ = 1, u_ = 2, gamma_ = 1.4, half_width_ = 0.5;
    double time_ = 0.1;
    Points points_{"x", app::any, {0, 1}};
};

}  // namespace

std::unique_ptr<Solution> rarefaction() {
    return std::make_unique<RarefactionSolution>();
}

}  // namespace exact::program
