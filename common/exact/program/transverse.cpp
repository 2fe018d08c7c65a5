#include "common/exact/transverse.hpp"

#include <fmt/format.h>

#include <cmath>

#include "common/app/error.hpp"
#include "common/exact/program/csv.hpp"
#include "common/exact/program/points.hpp"
#include "common/exact/program/solutions.hpp"

namespace exact::program {
namespace {

class TransverseSolution : public Solution {
  public:
    std::string name() const override { return "transverse"; }
    std::string description() const override {
        return "a boost-invariant cylinder that expands into the vacuum: r,temperature,rapidity";
    }

    void declare(app::CommandLine& command) override {
        command.number("radius", flow_.radius, {1e-6, 1e6}, "length", "of the cylinder at tau0, R");
        command.number("tau0", flow_.tau0, {1e-10, 1e10}, "length",
                       "proper time when it is released, 1e-4..1e4 R; c = 1");
        command.number("sound-speed-squared", flow_.c2, {0.01, 0.5}, "", "p/eps");
        command.number("tau", tau_, app::positive, "length", "proper time, tau0..tau0 + 4 R/c0");
        command.number("surface", surface_, {0, 1, true, true}, "T0",
                       "instead of a profile: tau,r of where the fluid has this temperature");
        points_.declare(command, "distances from the axis");
        command.footer(
            "By characteristics. The temperature is in units of its value at tau0, rapidity = artanh v_r.\n"
            "In the vacuum, r >= R + tau - tau0, both are 0.\n"
            "Example: exact transverse --tau 15 --points 241 --window 0,24");
    }

    std::string csv(const app::CommandLine& command) const override {
        check();
        Csv csv;
        csv.parameter("radius", flow_.radius).parameter("tau0", flow_.tau0);
        csv.parameter("sound_speed_squared", flow_.c2).parameter("axis_time", flow_.axis_time());
        if (command.given("surface")) return surface(csv, command);
        const auto points = points_.values(command);
        if (!(tau_ >= flow_.tau0 && tau_ <= flow_.last_time()))
            throw app::UsageError{
                fmt::format("--tau: {} is not allowed; allowed: {}..{} (tau0..tau0 + 4 R/c0)", tau_,
                            flow_.tau0, flow_.last_time())};
        const TransverseProfile profile{flow_, tau_};
        csv.parameter("tau", tau_).parameter("head", flow_.head(tau_)).parameter("edge", flow_.edge(tau_));
        csv.parameter("bjorken_temperature", flow_.bjorken(tau_));
        csv.parameter("estimated_error", profile.estimated_error()).columns("r,temperature,rapidity");
        for (const double r : points) {
            const auto state = profile.at(r);
            csv.row({r, state.temperature, state.rapidity});
        }
        return csv.text();
    }

  private:
    void check() const {
        const double least = 1e-4 * flow_.radius, most = 1e4 * flow_.radius;
        if (flow_.tau0 < least || flow_.tau0 > most)
            throw app::UsageError{fmt::format("--tau0: {} is not allowed; allowed: {}..{} (1e-4..1e4 R)",
                                              flow_.tau0, least, most)};
    }

    std::string surface(Csv& csv, const app::CommandLine& command) const {
        for (const char* other : {"r", "points", "tau"})
            if (command.given(other))
                throw app::UsageError{fmt::format("--surface and --{}: give one of them, not both", other)};
        const double least = lowest_surface(flow_);
        if (surface_ < least)
            throw app::UsageError{fmt::format(
                "--surface: {} is not allowed; allowed: {:.4}..1 (e^(-5 c0)..1)", surface_, least)};
        csv.parameter("surface", surface_).columns("tau,r");
        for (const auto& [tau, r] : freeze_out_surface(flow_, surface_)) csv.row({tau, r});
        return csv.text();
    }

    TransverseFlow flow_;
    double tau_ = 10, surface_ = 0.5;
    Points points_{"r", app::non_negative, {0, 24}};
};

}  // namespace

std::unique_ptr<Solution> transverse() {
    return std::make_unique<TransverseSolution>();
}

}  // namespace exact::program
