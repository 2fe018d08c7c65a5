#include "common/exact/toy_star.hpp"

#include <stdexcept>

#include "common/app/error.hpp"
#include "common/exact/program/csv.hpp"
#include "common/exact/program/solutions.hpp"
#include "common/exact/toy_star_modes.hpp"

namespace exact::program {
namespace {

class ToyStarSolution : public Solution {
  public:
    std::string name() const override { return "toy-star"; }
    std::string description() const override {
        return "Gas in a linear force, P = K rho^gamma, rho^(gamma-1) = H - C x^2, v = A x: frequencies of "
               "small "
               "oscillations (mode,omega), or large pulsations (t,A,H,C,radius)";
    }

    void declare(app::CommandLine& command) override {
        const app::Range scale{ToyStar::least_scale, ToyStar::largest_scale};
        command.number("gamma", gamma_, {1, ToyStar::largest_gamma, true}, "", "adiabatic index");
        command.integer("modes", modes_, 1, toy_star_largest_mode,
                        "frequencies of modes 1 to N in units of Omega; mode n has a velocity polynomial of "
                        "degree n - 1");
        command.numbers("time", times_, {-ToyStar::largest_time, ToyStar::largest_time}, "",
                        "instead of --modes: times of the pulsation, a comma-separated list");
        command.number("omega", Omega_, {ToyStar::least_omega, ToyStar::largest_omega}, "1/time",
                       "square root of force over distance and mass");
        command.number("k", K_, scale, "P/rho^gamma", "K of the equation of state");
        command.number("a0", A0_, {-ToyStar::largest_rate, ToyStar::largest_rate}, "1/time",
                       "A = v/x at t = 0");
        command.number("h0", H0_, scale, "rho^(gamma-1)", "H at t = 0");
        command.number("c0", C0_, scale, "rho^(gamma-1)/length^2", "C at t = 0");
        command.footer(
            "Examples: exact toy-star --gamma 2 --modes 20\n          exact toy-star --time 0.5,1,2");
    }

    std::string csv(const app::CommandLine& command) const override {
        if (command.given("modes") == command.given("time"))
            throw app::UsageError{command.given("modes")
                                      ? "--modes and --time: give one of them, not both"
                                      : "--modes or --time: missing; give --modes N, or --time LIST"};
        if (command.given("time")) return pulsation();
        for (const std::string option : {"omega", "k", "a0", "h0", "c0"})
            if (command.given(option)) throw app::UsageError{"--" + option + ": goes with --time LIST"};
        return frequencies();
    }

  private:
    std::string frequencies() const {
        Csv csv;
        csv.parameter("gamma", gamma_).columns("mode,omega");
        for (int mode = 1; mode <= modes_; ++mode)
            csv.row({static_cast<double>(mode), toy_star_frequency(gamma_, mode)});
        return csv.text();
    }

    std::string pulsation() const {
        const ToyStar star = checked_star();
        Csv csv;
        csv.parameter("gamma", gamma_).parameter("k", K_).parameter("omega", Omega_);
        csv.parameter("a0", A0_).parameter("h0", H0_).parameter("c0", C0_);
        csv.parameter("period", star.period()).columns("t,A,H,C,radius");
        for (const double t : times_) {
            const auto state = star.at(t);
            csv.row({t, state.A, state.H, state.C, state.radius});
        }
        return csv.text();
    }

    /// The options' ranges leave one reason to refuse them: a star that falls together too far.
    ToyStar checked_star() const {
        try {
            return {gamma_, K_, Omega_, A0_, H0_, C0_};
        } catch (const std::domain_error& error) {
            throw app::UsageError{std::string{"--a0: "} + error.what()};
        }
    }

    double gamma_ = 2;
    long modes_ = 20;
    std::vector<double> times_;
    double Omega_ = 1, K_ = 0.25, A0_ = 1, H0_ = 1, C0_ = 1;
};

}  // namespace

std::unique_ptr<Solution> toy_star() {
    return std::make_unique<ToyStarSolution>();
}

}  // namespace exact::program
