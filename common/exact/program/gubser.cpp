#include "common/exact/gubser.hpp"

#include "common/exact/program/csv.hpp"
#include "common/exact/program/points.hpp"
#include "common/exact/program/solutions.hpp"

namespace exact::program {
namespace {

class GubserSolution : public Solution {
  public:
    std::string name() const override { return "gubser"; }
    std::string description() const override {
        return "Gubser's flow, boost-invariant and radially expanding: r,eps,u_r";
    }

    void declare(app::CommandLine& command) override {
        command.number("q", flow_.q, {1e-6, 1e6}, "1/length", "one over the transverse size");
        command.number("tau", tau_, {1e-6, 1e6}, "length", "proper time, c = 1");
        points_.declare(command, "distances from the axis");
        command.footer(
            "p = eps/3; eps = 1 at q = tau = 1, r = 0.\n"
            "Example: exact gubser --q 1 --tau 1.5 --points 101 --window 0,5");
    }

    std::string csv(const app::CommandLine& command) const override {
        const auto points = points_.values(command);
        Csv csv;
        csv.parameter("q", flow_.q).parameter("tau", tau_).columns("r,eps,u_r");
        for (const double r : points) {
            const GubserFlow::State state = flow_.at(tau_, r);
            csv.row({r, state.eps, state.u_r});
        }
        return csv.text();
    }

  private:
    GubserFlow flow_;
    double tau_ = 1;
    Points points_{"r", {0, 1e6}, {0, 5}};
};

}  // namespace

std::unique_ptr<Solution> gubser() {
    return std::make_unique<GubserSolution>();
}

}  // namespace exact::program
