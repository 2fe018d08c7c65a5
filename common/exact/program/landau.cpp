#include "common/exact/landau.hpp"

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
        command.footer(
            "In units of the slab at rest; p = eps/3. s_star is the entropy density in the frame of the\n"
            "slab, the others are the fluid's own. In the vacuum, |x| >= 1 + time, all columns are 0.\n"
            "Example: exact landau --time 4 --points 501 --window -5,5");
    }

    std::string csv(const app::CommandLine& command) const override {
        const auto points = points_.values(command);
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
    double time_ = 4;
    Points points_{"x", app::any, {0, 5}};
};

}  // namespace

std::unique_ptr<Solution> landau() {
    return std::make_unique<LandauSolution>();
}

}  // namespace exact::program
