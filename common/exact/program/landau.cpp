#include "common/exact/landau.hpp"

#include <fmt/format.h>

#include <cmath>

#include "common/app/error.hpp"
#include "common/exact/landau_asymptotic.hpp"
#include "common/exact/program/csv.hpp"
#include "common/exact/program/points.hpp"
#include "common/exact/program/solutions.hpp"

namespace exact::program {
namespace {

class LandauSolution : public Solution {
  public:
    std::string name() const override { return "landau"; }
    std::string description() const override {
        return "Landau's slab of relativistic fluid in the vacuum: x,s_star,eps,rapidity,temperature";
    }

    void declare(app::CommandLine& command) override {
        command.number("time", time_, {0, LandauSlab::largest_time}, "half the slab's width",
                       "since the release, c = 1");
        points_.declare(command, "positions; the slab is |x| <= 1 at first");
        command.flag(
            "asymptotic", asymptotic_,
            "Chen's (2017) equations 247-249 instead, which are no limit of the slab; from time 1 on");
        command.footer(
            "In units of the slab at rest; p = eps/3. s_star is the entropy density in the frame of the\n"
            "slab, the others are the fluid's own. In the vacuum, |x| >= 1 + time, all columns are 0.\n"
            "With --asymptotic they are 0 where |x| > time - delta: eq. 248 has no value there.\n"
            "Example: exact landau --time 4 --points 501 --window -5,5");
    }

    std::string csv(const app::CommandLine& command) const override {
        const auto points = points_.values(command);
        if (asymptotic_) return asymptotic(points);
        const LandauSlab slab{time_};
        Csv csv;
        csv.parameter("time", time_).parameter("edge", slab.edge()).parameter("matching", slab.matching());
        csv.columns("x,s_star,eps,rapidity,temperature");
        for (const double x : points) {
            const LandauSlab::State state = slab.at(x);
            csv.row({x, state.s_star, state.eps, state.rapidity, state.temperature});
        }
        return csv.text();
    }

  private:
    std::string asymptotic(const std::vector<double>& points) const {
        if (time_ < 1)
            throw app::UsageError{
                fmt::format("--time: {} is not allowed; allowed with --asymptotic: 1..1e6", time_)};
        const LandauAsymptotics slab{time_};
        Csv csv;
        csv.parameter("time", time_).parameter("delta", LandauAsymptotics::delta());
        csv.columns("x,s_star,eps,rapidity,temperature");
        for (const double x : points) {
            if (!slab.holds(x)) {
                csv.row({x, 0, 0, 0, 0});
                continue;
            }
            const auto [rapidity, log_temperature, log_bjorken] = slab.at(x);
            csv.row({x, std::exp(3 * log_temperature) * std::cosh(rapidity), std::exp(4 * log_temperature),
                     rapidity, std::exp(log_temperature)});
        }
        return csv.text();
    }

    double time_ = 4;
    bool asymptotic_ = false;
    Points points_{"x", app::any, {0, 5}};
};

}  // namespace

std::unique_ptr<Solution> landau() {
    return std::make_unique<LandauSolution>();
}

}  // namespace exact::program
