#include "common/exact/sedov.hpp"

#include <fmt/format.h>

#include <cmath>

#include "common/app/error.hpp"
#include "common/exact/program/csv.hpp"
#include "common/exact/program/points.hpp"
#include "common/exact/program/solutions.hpp"

namespace exact::program {
namespace {

class SedovSolution : public Solution {
  public:
    std::string name() const override { return "sedov"; }
    std::string description() const override {
        return "the point blast of Sedov and Taylor in a cold uniform gas: r,rho,v,p,u";
    }

    void declare(app::CommandLine& command) override {
        const app::Range scale{Sedov::least_scale, Sedov::largest_scale};
        command.integer("dimension", dimension_, 1, 3, "of space: 1 plane, 2 cylindrical, 3 spherical blast");
        command.number("gamma", gamma_, {SedovProfile::least_gamma, SedovProfile::largest_gamma}, "",
                       "adiabatic index; below 7 for --dimension 3");
        command.number("energy", energy_, scale, "mass length^2/time^2",
                       "released at t = 0: of both sides and per area for --dimension 1, per length for 2");
        command.number("density", density_, scale, "mass/length^dimension", "density of the cold gas");
        command.number("time", time_, scale, "time", "since the release");
        points_.declare(command, "distances from the blast, above 0, where u is infinite");
        command.footer("Example: exact sedov --dimension 2 --gamma 1.4 --points 120 --window 0.01,1.2");
    }

    std::string csv(const app::CommandLine& command) const override {
        const auto points = points_.values(command);
        if (dimension_ == 3 && !(gamma_ < SedovProfile::vacuum_gamma))
            throw app::UsageError{fmt::format(
                "--gamma: {} is not allowed; allowed: below 7 for --dimension 3 (a vacuum opens beyond)",
                gamma_)};
        const Sedov solution{static_cast<int>(dimension_), gamma_, energy_, density_};
        const Sedov::State post = solution.post_shock(time_);
        Csv csv;
        csv.parameter("dimension", static_cast<double>(dimension_)).parameter("gamma", gamma_);
        csv.parameter("energy", energy_).parameter("density", density_).parameter("time", time_);
        csv.parameter("alpha", solution.alpha()).parameter("shock_radius", solution.shock_radius(time_));
        csv.parameter("shock_speed", solution.shock_speed(time_)).parameter("rho_post", post.rho);
        csv.parameter("v_post", post.v).parameter("p_post", post.p).parameter("u_post", post.u);
        csv.columns("r,rho,v,p,u");
        for (const double r : points) {
            const auto [rho, v, p, u] = solution.at(r, time_);
            if (!std::isfinite(u)) refuse(command, r);
            csv.row({r, rho, v, p, u});
        }
        return csv.text();
    }

  private:
    [[noreturn]] static void refuse(const app::CommandLine& command, double r) {
        throw app::UsageError{
            fmt::format("--{}: {} is not allowed; allowed: distances farther from the blast, where u = "
                        "p/((gamma-1) rho) is below 1.8e308",
                        command.given("r") ? "r" : "window", r)};
    }

    long dimension_ = 3;
    double gamma_ = 1.4, energy_ = 1, density_ = 1, time_ = 1;
    Points points_{"r", app::positive, {0.01, 1.2}};
};

}  // namespace

std::unique_ptr<Solution> sedov() {
    return std::make_unique<SedovSolution>();
}

}  // namespace exact::program
