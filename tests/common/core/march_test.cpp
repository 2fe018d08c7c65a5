// The only time loop of the book.
#include "common/core/march.hpp"

#include <catch2/catch.hpp>
#include <csignal>
#include <stdexcept>
#include <vector>

#include "common/app/program.hpp"
#include "common/core/unstable.hpp"
#include "tests/common/app/child.hpp"

using namespace sph;
using Lengths = std::vector<double>;

namespace {

/// Takes steps up to `accepted`, asks for at most `limit`, and remembers what it took.
class Recorder : public Stepper {
  public:
    double limit = std::numeric_limits<double>::infinity(), accepted = limit;
    Lengths taken;

    double longest_step() override { return limit; }
    bool step(double& t, double dt) override {
        if (dt > accepted) return false;
        t += dt;
        taken.push_back(dt);
        return true;
    }
};

void check_lengths(const Lengths& taken, const Lengths& expected) {
    REQUIRE(taken.size() == expected.size());
    for (std::size_t k = 0; k < taken.size(); ++k) CHECK(taken[k] == Approx(expected[k]).epsilon(1e-12));
}

}  // namespace

TEST_CASE("steps as long as the stepper allows, without a crumb at the end") {
    // Fails if the last steps are 0.3 and 0.1, or if t stops a rounding before the end.
    Recorder stepper;
    stepper.limit = 0.3;
    double t = 0;
    const Marched done = march(stepper, t, {.end = 1});
    check_lengths(stepper.taken, {0.3, 0.3, 0.2, 0.2});
    CHECK(t == 1);
    CHECK(done.steps == 4);
    CHECK(done.retries == 0);
    CHECK(done.seconds >= 0);
    CHECK(march(stepper, t, {.end = 1}).steps == 0);  // it is there
}

TEST_CASE("without a limit one step leads to the end") {
    Recorder stepper;
    double t = 0.25;
    march(stepper, t, {.end = 2});
    check_lengths(stepper.taken, {1.75});
    CHECK(t == 2);
    // -0.4 + 0.5 is not 0.1 in double precision. Fails if what rounding leaves is another step.
    t = -0.4;
    CHECK(march(stepper, t, {.end = 0.1}).steps == 1);
    CHECK(t == 0.1);
}

TEST_CASE("rounding of what is left is no reason for another step") {
    // Fails if the limit is compared to the last bit: eight steps.
    Recorder stepper;
    stepper.limit = 0.1;
    double t = 0.3;
    CHECK(march(stepper, t, {.end = 1}).steps == 7);
    CHECK(t == 1);
}

TEST_CASE("an equal step that is refused is taken in parts, and the march reaches its end") {
    // Fails if the halved step counts as one: t would end at 0.75.
    Recorder stepper;
    stepper.accepted = 0.25;
    double t = 0;
    int told = 0;
    const Marched done = march(stepper, t, {.end = 1, .steps = 2}, [&](double) { ++told; });
    check_lengths(stepper.taken, {0.25, 0.25, 0.25, 0.25});
    CHECK(t == 1);
    CHECK(done.steps == 2);
    CHECK(done.retries == 2);
    CHECK(told == 2);
}

TEST_CASE("equal steps") {
    // Fails if the stepper's own limit is looked at, or if the last step is another one.
    Recorder stepper;
    stepper.limit = 0.01;
    double t = 1;
    CHECK(march(stepper, t, {.end = 3, .steps = 5}).steps == 5);
    check_lengths(stepper.taken, {0.4, 0.4, 0.4, 0.4, 0.4});
    CHECK(t == Approx(3));
    // Without an end: so many of the stepper's own.
    stepper.taken.clear();
    CHECK(march(stepper, t, {.steps = 3}).steps == 3);
    check_lengths(stepper.taken, {0.01, 0.01, 0.01});
    CHECK_THROWS_AS(march(stepper, t, {}), std::invalid_argument);
}

TEST_CASE("a step that is not taken is tried again with half the length") {
    // Fails if retries are not counted, or if t jumps to the end although the last step was cut.
    Recorder stepper;
    stepper.limit = 0.4;
    stepper.accepted = 0.16;
    double t = 0;
    const Marched done = march(stepper, t, {.end = 0.4});
    check_lengths(stepper.taken, {0.1, 0.15, 0.15});
    CHECK(t == 0.4);
    CHECK(done.retries == 3);
    CHECK(done.steps == 3);
    stepper.accepted = 0;
    CHECK_THROWS_WITH(march(stepper, t, {.end = 1, .most_retries = 3}),
                      "unphysical state at t = 0.4: the time step after 3 halvings is 0.0375");
}

TEST_CASE("a march that does not get on is stopped") {
    // Each fails if its check is left out: the run would last for ever.
    Recorder stepper;
    double t = 0;
    stepper.limit = 0;
    CHECK_THROWS_WITH(march(stepper, t, {.end = 1}), "unphysical state at t = 0: the time step is 0");
    stepper.limit = std::nan("");
    CHECK_THROWS_WITH(march(stepper, t, {.end = 1}), "unphysical state at t = 0: the time step is nan");
    CHECK(stepper.taken.empty());
    stepper.limit = 0x1p-10;
    CHECK_THROWS_WITH(march(stepper, t, {.end = 1, .most_steps = 100}),
                      "unphysical state at t = 0.0976562: the number of steps is 100");
    CHECK(stepper.taken.size() == 100);
}

TEST_CASE("what is called after a step sees its time, and may end the march") {
    // Fails if it is called before the step, or if false is not heard.
    Recorder stepper;
    stepper.limit = 0.125;
    double t = 0;
    Lengths seen;
    const Marched done = march(stepper, t, {.end = 1}, [&](double now) {
        seen.push_back(now);
        return seen.size() < 3;
    });
    CHECK(done.steps == 3);
    check_lengths(seen, {0.125, 0.25, 0.375});
    CHECK(t == 0.375);
    seen.clear();
    march(stepper, t, {.end = 1}, [&](double now) { seen.push_back(now); });  // without an answer: go on
    CHECK(seen.size() == 5);
    CHECK(seen.back() == 1);
}

TEST_CASE("progress is told as a share of the way") {
    // Fails if the share is one of the time instead of the way from the start.
    Recorder stepper;
    stepper.limit = 0.5;
    double t = 1;
    Lengths shares;
    StepControl how{.end = 3, .progress = [&](double share) { shares.push_back(share); }};
    march(stepper, t, how);
    check_lengths(shares, {0.25, 0.5, 0.75, 1});
    shares.clear();
    how.end = 5;
    how.steps = 2;
    march(stepper, t, how);
    check_lengths(shares, {0.5, 1});
}

TEST_CASE("Ctrl-C is heard between two steps") {
    // Fails if the loop does not look: status 0 after 1000 steps.
    const auto outcome = child::run([] {
        return app::run([] {
            Recorder stepper;
            double t = 0;
            march(stepper, t, {.end = 1, .steps = 1000}, [&](double) {
                if (stepper.taken.size() == 5) std::raise(SIGINT);
                if (stepper.taken.size() > 5) throw std::runtime_error{"went on"};
            });
        });
    });
    CHECK(outcome.status == 130);
}
