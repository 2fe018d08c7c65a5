// What scenes and time loops need of any particle method, without its types.
#include "common/core/simulation.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "common/core/integrated.hpp"

using namespace sph;

namespace {

/// Beads on springs, x'' = - x: as small as a method can be.
class Beads : public Integrated<1> {
  public:
    explicit Beads(std::size_t n) : beads_{n} {
        offer(beads_);
        motion_.evolve<Position, Velocity>(beads_).evolve<Velocity, Acceleration>(beads_);
    }
    void start(double t) override { resolve(t); }
    void resolve(double) override {}
    void rates(double) override {
        for (std::size_t i = 0; i < beads_.size(); ++i) beads_.dv_dt[0][i] = -beads_.x[0][i];
    }
    Totals<1> totals() const override {
        Totals<1> sum;
        for (std::size_t i = 0; i < beads_.size(); ++i) {
            const double m = beads_.m[i], x = beads_.x[0][i], v = beads_.v[0][i];
            sum.mass += m;
            sum.momentum[0] += m * v;
            sum.energy += 0.5 * m * (v * v + x * x);
        }
        return sum;
    }
    Groups& groups() override { return beads_.groups; }
    Counters& counters() override { return counters_; }

  private:
    Particles<1, Position, Velocity, Acceleration, Mass> beads_;
    Counters counters_;
};

/// Two beads, pulled apart.
void place(Simulation<1>& beads) {
    beads.get<Position>()[0] = {-1, 1};
    beads.get<Mass>() = {1, 2};
    beads.start(0);
}

}  // namespace

TEST_CASE("columns are found by type, and one that is missing is named") {
    // Fails if the column of another quantity is handed over.
    Beads beads{2};
    Simulation<1>& any = beads;
    place(any);
    CHECK(any.size() == 2);
    CHECK(any.has<Mass>());
    CHECK_FALSE(any.has<Pressure>());
    CHECK(std::as_const(any).get<Mass>()[1] == 2);
    CHECK(any.get<Position>()[0][0] == -1);
    CHECK(any.get<Velocity>()[0] == Column{0, 0});
    CHECK_THROWS_WITH(any.get<Pressure>(), "this method has no column of pressure");
    CHECK_THROWS_AS(any.get<SmoothingLength>(), std::out_of_range);
}

TEST_CASE("a march counts a simulation's steps, and drifts remember the largest deviation") {
    // Fails if a drift is that of the end only: the momentum swings, and after half a period it is back.
    Beads beads{2};
    place(beads);
    Drifts<1> drifts{beads};
    double t = 0;
    const double pi = std::acos(-1.0);
    march(beads, t, {.end = pi, .steps = 400}, [&](double) { drifts.look(); });
    CHECK(beads.counters().steps == 400);
    CHECK(beads.get<Position>()[0][1] == Approx(-1).epsilon(1e-4));
    CHECK(std::abs(beads.totals().momentum[0]) < 1e-4);
    CHECK(drifts.momentum() == Approx(1).epsilon(1e-4));  // 2 - 1 at a quarter of the period
    CHECK(drifts.first().energy == 1.5);
    CHECK(drifts.energy() > 0);
    CHECK(drifts.energy() < 1e-4);  // measured 2.3e-5: leapfrog
    march(beads, t, {.end = 2 * pi, .steps = 400});
    CHECK(beads.counters().steps == 800);
}

TEST_CASE("a scene may choose the integrator and limit the steps") {
    // Fails if the limit is not asked, or if the integrator in use stays leapfrog.
    Beads beads{2};
    place(beads);
    double t = 0;
    beads.limit_steps([] { return 0.5; });
    CHECK(beads.longest_step() == 0.5);
    beads.integrate_by<RungeKutta4>();
    CHECK(march(beads, t, {.end = 1}).steps == 2);
    CHECK(beads.get<Position>()[0][1] ==
          Approx(std::cos(1.0)).epsilon(1e-3));  // measured 5e-4; leapfrog: 2e-2
    beads.groups().hold("second", 1, 2);
    const double v = beads.get<Velocity>()[0][1];
    march(beads, t, {.end = 2});
    CHECK(beads.get<Velocity>()[0][1] == v);
    CHECK(beads.groups().free(beads.size()) == 1);
}
