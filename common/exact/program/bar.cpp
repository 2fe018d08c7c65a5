#include "common/app/error.hpp"
#include "common/exact/program/csv.hpp"
#include "common/exact/program/solutions.hpp"
#include "common/exact/struck_bar.hpp"

namespace exact::program {
namespace {

class BarSolution : public Solution {
  public:
    std::string name() const override { return "bar"; }
    std::string description() const override {
        return "a bar of masses and springs between fixed ends, one mass struck at t = 0 (the discrete wave "
               "equation, c = dx = 1), at any tension: t,u,v of one mass";
    }

    void declare(app::CommandLine& command) override {
        command.integer("particles", masses_, 1, 10000, "free masses between the ends");
        command.integer("struck", struck_, 1, 10000, "the mass that is struck; default: the middle one");
        command.integer("observed", observed_, 1, 10000, "the mass that is shown; default: the one struck");
        command.number("velocity", velocity_, {-1e50, 1e50}, "c", "of the struck mass at t = 0");
        command.numbers("time", times_, {0, StruckBar::largest_time}, "dx/c", "a comma-separated list");
        command.footer("Example: exact bar --particles 41 --velocity 1e-3 --time 0,1,2,5,10");
    }

    std::string csv(const app::CommandLine& command) const override {
        if (!command.given("time")) throw app::UsageError{"--time: missing; give --time LIST"};
        const int masses = static_cast<int>(masses_);
        const int struck = command.given("struck") ? checked("struck", struck_) : (masses + 1) / 2;
        const int observed = command.given("observed") ? checked("observed", observed_) : struck;
        const StruckBar bar{masses, struck, velocity_};
        Csv csv;
        csv.parameter("particles", masses).parameter("struck", struck).parameter("observed", observed);
        csv.parameter("velocity", velocity_).columns("t,u,v");
        for (const double t : times_) csv.row({t, bar.displacement(observed, t), bar.velocity(observed, t)});
        return csv.text();
    }

  private:
    int checked(const std::string& option, long mass) const {
        if (mass > masses_) {
            throw app::UsageError{"--" + option + ": " + std::to_string(mass) + " lies outside 1.." +
                                  std::to_string(masses_) + ", the particles"};
        }
        return static_cast<int>(mass);
    }

    long masses_ = 41, struck_ = 1, observed_ = 1;
    double velocity_ = 1e-3;
    std::vector<double> times_;
};

}  // namespace

std::unique_ptr<Solution> bar() {
    return std::make_unique<BarSolution>();
}

}  // namespace exact::program
