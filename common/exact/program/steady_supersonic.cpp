#include "common/exact/steady_supersonic.hpp"

#include <fmt/format.h>

#include <numbers>

#include "common/app/error.hpp"
#include "common/exact/program/csv.hpp"
#include "common/exact/program/solutions.hpp"

namespace exact::program {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// What both take.
struct Turn {
    double mach = 2, angle = 15, gamma = 1.4;
    void declare(app::CommandLine& command, bool supersonic) {
        command.number("mach", mach, {1, TurnedFlow::largest_mach, supersonic}, "", "Mach number ahead");
        command.number("angle", angle, {0, 360}, "degrees", "by which the wall turns");
        command.number("gamma", gamma, {1, TurnedFlow::largest_gamma, true}, "", "adiabatic index");
    }
    Csv csv() const {
        Csv csv;
        csv.parameter("mach", mach).parameter("angle", angle).parameter("gamma", gamma);
        return csv;
    }
};

class ObliqueShockSolution : public Solution {
  public:
    std::string name() const override { return "oblique-shock"; }
    std::string description() const override {
        return "a supersonic flow that a wall turns by an angle, through an attached shock: its angle beta "
               "and the state behind it";
    }
    void declare(app::CommandLine& command) override {
        turn_.declare(command, true);
        command.choice("branch", branch_, {"weak", "strong"}, "which of the two shocks that turn so far");
        command.footer("Angles in degrees. Example: exact oblique-shock --mach 2 --angle 15 --gamma 1.4");
    }
    std::string csv(const app::CommandLine&) const override {
        const double largest = ObliqueShock::largest_angle(turn_.mach, turn_.gamma) / degree;
        if (turn_.angle > largest)
            throw app::UsageError{
                fmt::format("--angle: {} is not allowed; allowed: 0..{:.6g} (theta_max at Mach {}): a shock "
                            "that turns farther is detached",
                            turn_.angle, largest, turn_.mach)};
        const auto branch = branch_ == "strong" ? ObliqueShock::Branch::strong : ObliqueShock::Branch::weak;
        const ObliqueShock shock{turn_.mach, turn_.angle * degree, turn_.gamma, branch};
        Csv csv = turn_.csv();
        csv.parameter("beta", shock.beta() / degree).parameter("mach2", shock.mach_behind());
        csv.parameter("p_ratio", shock.p_ratio()).parameter("rho_ratio", shock.rho_ratio());
        csv.parameter("theta_max", largest).columns("beta,mach2,p_ratio,rho_ratio");
        csv.row({shock.beta() / degree, shock.mach_behind(), shock.p_ratio(), shock.rho_ratio()});
        return csv.text();
    }

  private:
    Turn turn_;
    std::string branch_ = "weak";
};

class PrandtlMeyerSolution : public Solution {
  public:
    std::string name() const override { return "prandtl-meyer"; }
    std::string description() const override {
        return "a supersonic flow along a wall that turns away from it by an angle: the state behind the fan";
    }
    void declare(app::CommandLine& command) override {
        turn_.declare(command, false);
        command.footer("Angles in degrees. Example: exact prandtl-meyer --mach 2 --angle 15 --gamma 1.4");
    }
    std::string csv(const app::CommandLine&) const override {
        const double largest = PrandtlMeyer::largest_angle(turn_.mach, turn_.gamma) / degree;
        if (!(turn_.angle < largest))
            throw app::UsageError{
                fmt::format("--angle: {} is not allowed; allowed: below {:.6g}, where the gas at Mach {} "
                            "reaches the vacuum",
                            turn_.angle, largest, turn_.mach)};
        const PrandtlMeyer fan{turn_.mach, turn_.angle * degree, turn_.gamma};
        const double nu = PrandtlMeyer::nu(turn_.mach, turn_.gamma) / degree;
        Csv csv = turn_.csv();
        csv.parameter("nu", nu).parameter("mach2", fan.mach_behind());
        csv.parameter("p_ratio", fan.p_ratio()).parameter("rho_ratio", fan.rho_ratio());
        csv.columns("nu2,mach2,p_ratio,rho_ratio");
        csv.row({nu + turn_.angle, fan.mach_behind(), fan.p_ratio(), fan.rho_ratio()});
        return csv.text();
    }

  private:
    Turn turn_;
};

}  // namespace

std::unique_ptr<Solution> oblique_shock() {
    return std::make_unique<ObliqueShockSolution>();
}
std::unique_ptr<Solution> prandtl_meyer() {
    return std::make_unique<PrandtlMeyerSolution>();
}

}  // namespace exact::program
