#include "common/exact/bjorken.hpp"

#include "common/exact/program/csv.hpp"
#include "common/exact/program/points.hpp"
#include "common/exact/program/solutions.hpp"

namespace exact::program {
namespace {

class BjorkenSolution : public Solution {
  public:
    std::string name() const override { return "bjorken"; }
    std::string description() const override {
        return "Bjorken's flow, v_z = z/t in a uniform fluid: tau,temperature,eps,s";
    }

    void declare(app::CommandLine& command) override {
        command.number("tau0", flow_.tau0, app::positive, "time", "proper time when all columns are 1");
        command.number("sound-speed-squared", flow_.c2, {0, 1}, "", "p/eps");
        points_.declare(command, "proper times, above 0");
        command.footer("Example: exact bjorken --points 101 --window 1,15");
    }

    std::string csv(const app::CommandLine& command) const override {
        const auto points = points_.values(command);
        Csv csv;
        csv.parameter("tau0", flow_.tau0).parameter("sound_speed_squared", flow_.c2);
        csv.columns("tau,temperature,eps,s");
        for (const double tau : points) {
            const BjorkenFlow::State state = flow_.at(tau);
            csv.row({tau, state.temperature, state.eps, state.entropy});
        }
        return csv.text();
    }

  private:
    BjorkenFlow flow_;
    Points points_{"tau", app::positive, {1, 15}};
};

}  // namespace

std::unique_ptr<Solution> bjorken() {
    return std::make_unique<BjorkenSolution>();
}

}  // namespace exact::program
