// The Riemann problem of relativistic gas against independent computations: `exact relativistic-riemann`.
#include "common/exact/relativistic_riemann.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "tests/common/exact/exact_program.hpp"
#include "tests/common/exact/relativistic_laws.hpp"

using exact::RelativisticRiemann;
using State = RelativisticRiemann::State;

namespace {

/// Star state, and the speeds of the left rarefaction's head and tail and of the right shock.
struct Known {
    std::string name;
    State left, right;
    double p, v, rho_left, rho_right, head, tail, shock;
};
/// Problems 1 and 2 of Marti and Mueller, gamma = 5/3, with 14 digits from arithmetic of 30. Of problem 1
/// three readings are in use.
const Known one_cold{"1, 13.33 and 1e-8", {10, 0, 13.33},   {1, 0, 1e-8},     1.44768268986221,
                     0.713990646020529,   2.63940441769288, 5.07063654537804, -0.716094212608247,
                     0.167222783763151,   0.828372622647991};
const Known two{"2",
                {1, 0, 1000},
                {1, 0, 0.01},
                18.5970786785543,
                0.960409611243625,
                0.0915517893921743,
                10.4155815827314,
                -0.816333330585011,
                0.668125119704091,
                0.986804253648688};
const std::vector<Known> table{one_cold,
                               two,
                               {"1, 13.33 and 2/3e-6",
                                {10, 0, 13.33},
                                {1, 0, 2e-6 / 3},
                                1.4476847570391,
                                0.713990385245407,
                                2.63940667900925,
                                5.07062398021961,
                                -0.716094212608247,
                                0.167222148388042,
                                0.828372699349746},
                               {"1, 40/3 and 2/3e-6",
                                {10, 0, 40.0 / 3},
                                {1, 0, 2e-6 / 3},
                                1.44794410654974,
                                0.71402083329111,
                                2.6392944017973,
                                5.07078234185816,
                                -0.716114874039433,
                                0.167236616444447,
                                0.828397995268502}};

/// A place in the profile of one_cold at t = 0.4, and of two at t = 0.35, with 14 digits.
struct Row {
    double x, rho, v, p;
};
const std::vector<Row> rows_one{{-0.288, 10, 0, 13.33},
                                {-0.284, 9.8515581597351, 0.010702935921935, 13.001846229073},
                                {-0.28, 9.6179469906799, 0.027845682646117, 12.492061528205},
                                {-0.276, 9.3958218367569, 0.044489635515683, 12.014935339827},
                                {0, 3.2853521128343, 0.63948166357947, 2.0851310416405},
                                {0.068, 2.6394044176929, 0.71399064602053, 1.4476826898622},
                                {0.284, 2.6394044176929, 0.71399064602053, 1.4476826898622},
                                {0.288, 5.070636545378, 0.71399064602053, 1.4476826898622},
                                {0.332, 1, 0, 1e-8}};
const std::vector<Row> rows_two{{-0.287, 1, 0, 1000},
                                {-0.2835, 0.97736533357568, 0.018687553448702, 962.5609039794},
                                {-0.28, 0.94394168828943, 0.047060022744095, 908.32641595832},
                                {-0.259, 0.78735508663341, 0.19272175134628, 671.35319886623},
                                {-0.2415, 0.69446701810569, 0.28914768412819, 544.61053920251},
                                {0.336, 0.091551789392174, 0.96040961124363, 18.597078678554},
                                {0.3395, 10.415581582731, 0.96040961124363, 18.597078678554},
                                {0.346, 1, 0, 0.01}};

void check_rows(const Known& known, double time, const std::vector<Row>& rows) {
    const RelativisticRiemann solution{known.left, known.right, 5.0 / 3};
    for (const Row& row : rows) {
        CAPTURE(known.name, row.x);
        const RelativisticRiemann::Point at = solution.at(row.x, time);
        CHECK(at.rho == Approx(row.rho).epsilon(1e-12));  // measured 4e-14, the rows' last digit
        CHECK(at.v == Approx(row.v).epsilon(1e-12));
        CHECK(at.p == Approx(row.p).epsilon(1e-12));
        CHECK(at.u == Approx(at.p / at.rho * 1.5).epsilon(1e-14));
        CHECK(std::tanh(at.rapidity) == Approx(at.v).epsilon(1e-14));
    }
}

}  // namespace

// Fails if pressures or densities are those of the laboratory, for c_s^2 = gamma p/rho, and for every sign of
// the adiabat.
TEST_CASE("relativistic riemann: the digits of an independent computation") {
    for (const Known& known : table) {
        CAPTURE(known.name);
        const RelativisticRiemann solution{known.left, known.right, 5.0 / 3};
        const auto& star = solution.star();
        const auto& waves = solution.waves();
        CHECK(star.p == Approx(known.p).epsilon(2e-14));  // measured 5e-15, the table's last digit
        CHECK(star.v == Approx(known.v).epsilon(2e-14));
        CHECK(star.rho_left == Approx(known.rho_left).epsilon(2e-14));
        CHECK(star.rho_right == Approx(known.rho_right).epsilon(2e-14));
        CHECK(star.u_right == Approx(1.5 * star.p / star.rho_right).epsilon(1e-15));
        CHECK(waves.left.head.v == Approx(known.head).epsilon(2e-14));
        CHECK(waves.left.tail.v == Approx(known.tail).epsilon(2e-14));
        CHECK(waves.contact.v == star.v);
        CHECK(waves.right.head.v == Approx(known.shock).epsilon(2e-14));
        CHECK(waves.right.tail.v == waves.right.head.v);
        CHECK(!waves.left.shock);
        CHECK(waves.right.shock);
        CHECK(!star.vacuum);
    }
    check_rows(one_cold, 0.4, rows_one);
    check_rows(two, 0.35, rows_two);
}

TEST_CASE("relativistic riemann: at discontinuities the state on the right, outside the light cone none") {
    const RelativisticRiemann colliding{{1, 0.5, 0.3}, {2, -0.5, 0.3}, 5.0 / 3};
    const auto& waves = colliding.waves();
    REQUIRE(waves.left.shock);
    REQUIRE(waves.right.shock);
    CHECK(colliding.at(waves.left.head.v - 1e-15).rho == 1);
    CHECK(colliding.at(waves.left.head.v + 1e-15).rho == colliding.star().rho_left);
    CHECK(colliding.at(waves.contact.v - 1e-15).rho == colliding.star().rho_left);
    CHECK(colliding.at(waves.contact.v + 1e-15).rho == colliding.star().rho_right);
    CHECK(colliding.at(waves.right.head.v - 1e-15).rho == colliding.star().rho_right);
    CHECK(colliding.at(waves.right.head.v + 1e-15).rho == 2);
    CHECK(colliding.at(-7).v == 0.5);
    CHECK(colliding.at(1).v == -0.5);
    CHECK(colliding.at(1e-300, 0).v == -0.5);
    CHECK(colliding.at(-1e-300, 0).v == 0.5);
    CHECK(colliding.at(0, 0).rho == 2);
    CHECK(colliding.at(-1e300, 1e-300).rho == 1);
    const RelativisticRiemann still{{1, 0, 1}, {2, 0, 1}, 5.0 / 3};
    CHECK(still.at(0.0).rho == 2);
    CHECK(still.at(-1e-300).rho == 1);
}

// Fails if the fronts move with 2 c_s/(gamma-1), and if a vacuum opens earlier or later.
TEST_CASE("relativistic riemann: vacuum between and beside") {
    const double gamma = 5.0 / 3;
    const double F = static_cast<double>(relativistic_laws::expansion(1, 0.01, gamma));
    CHECK(F == Approx(0.385702480524807).epsilon(1e-14));
    const double v = std::tanh(F);
    const RelativisticRiemann closed{{1, -v * (1 - 1e-9), 0.01}, {1, v * (1 - 1e-9), 0.01}, gamma};
    CHECK(!closed.star().vacuum);
    CHECK(closed.star().p > 0);
    CHECK(closed.star().p < 1e-40);
    const RelativisticRiemann open{{1, -v * (1 + 1e-9), 0.01}, {1, v * (1 + 1e-9), 0.01}, gamma};
    CHECK(open.star().vacuum);
    CHECK(open.star().p == 0);
    CHECK(open.star().rho_left == 0);
    CHECK(open.at(0.0).u == 0);

    const RelativisticRiemann beside{{1, 0, 0.01}, {0, 0, 0}, gamma};
    CHECK(beside.star().vacuum);
    CHECK(beside.waves().left.tail.v == Approx(v).epsilon(1e-14));
    CHECK(beside.waves().right.head.v == beside.star().v);
    CHECK(beside.at(v * (1 + 1e-12)).rho == 0);
    CHECK(beside.at(v * (1 - 1e-3)).rho > 0);
    CHECK(beside.at(v * (1 - 1e-3)).rho < 1e-8);
    const RelativisticRiemann mirror{{0, 0, 0}, {1, 0, 0.01}, gamma};
    for (const double xi : {-0.9, -0.3, -0.1, 0.0, 0.05, 0.2}) {
        CHECK(mirror.at(xi).rho == beside.at(-xi).rho);
        CHECK(mirror.at(xi).v == -beside.at(-xi).v);
    }
    // Cold gas does not expand: a gap opens between its edges, which keep their velocities.
    const RelativisticRiemann parting{{1, -0.5, 0}, {2, 0.6, 0}, gamma};
    CHECK(parting.star().vacuum);
    CHECK(parting.at(-0.5001).rho == 1);
    CHECK(parting.at(-0.4999).rho == 0);
    CHECK(parting.at(0.5999).rho == 0);
    CHECK(parting.at(0.6001).v == 0.6);
    const RelativisticRiemann together{{1, 0.6, 0}, {2, 0.6, 0}, gamma};
    CHECK(!together.star().vacuum);
    CHECK(together.star().v == 0.6);
    CHECK(together.star().rho_left == 1);
    CHECK(together.at(0.6001).rho == 2);
}

TEST_CASE("relativistic riemann: what has no meaning is refused by name") {
    const auto refused = [](const State& left, const State& right, double gamma, const std::string& name) {
        CHECK_THROWS_WITH((RelativisticRiemann{left, right, gamma}), Catch::Contains(name));
        CHECK_THROWS_AS((RelativisticRiemann{left, right, gamma}), std::domain_error);
    };
    const State good{1, 0, 1};
    refused(good, good, 1, "gamma = 1 lies");
    refused(good, good, 2.0000001, "gamma");
    refused({-1, 0, 1}, good, 1.4, "rho = -1");
    refused({1e-101, 0, 1}, good, 1.4, "rho");
    refused(good, {1, 1, 1}, 1.4, "v = 1 ");
    refused(good, {1, std::nan(""), 1}, 1.4, "v = ");
    refused(good, {1, 0, -1}, 1.4, "p = -1");
    refused(good, {0, 0, 1}, 1.4, "vacuum");
    refused({0, 0, 0}, {0, 0, 0}, 1.4, "both sides");
    const RelativisticRiemann solution{good, good, 1.4};
    CHECK_THROWS_WITH(solution.at(std::nan("")), Catch::Contains("x/t"));
    CHECK_THROWS_WITH(solution.at(INFINITY, 1), Catch::Contains("x = inf"));
    CHECK_THROWS_WITH(solution.at(0, -1), Catch::Contains("time = -1"));
}

// Fails if the wrong way is chosen, the sign is lost, or only one side is converted.
TEST_CASE("exact relativistic-riemann: velocities told as Lorentz factors or four-velocities") {
    using namespace exact_program;
    // v = -0.8 has W = 5/3 and W v = -4/3, v = 0.6 has 5/4 and 3/4.
    const auto told = [](const std::string& how) {
        const auto all = lines(run("relativistic-riemann --x 0.05 " + how).text);
        REQUIRE(all.size() == 8);
        return numbers(all.back());
    };
    const auto v = told("--left 1,-0.8,1 --right 2,0.6,0.1"),
               W = told("--left 1,-5/3,1 --right 2,5/4,0.1 --velocity lorentz"),
               U = told("--left 1,-4/3,1 --right 2,3/4,0.1 --velocity four-velocity");
    for (std::size_t k = 0; k < v.size(); ++k) {
        CHECK(W[k] == Approx(v[k]).epsilon(1e-13));
        CHECK(U[k] == Approx(v[k]).epsilon(1e-13));
    }
}

// Fails if an option does not reach the solution, for exchanged columns, and for other defaults.
TEST_CASE("exact relativistic-riemann: header, columns, defaults and refusals") {
    using namespace exact_program;
    const auto all = lines(
        run("relativistic-riemann --left 1,-0.2,0.4 --right=2,0.1,0.5 --gamma 1.4 --time 0.15 --x -0.1,0,0.1")
            .text);
    REQUIRE(all.size() == 7 + 3);
    const RelativisticRiemann solution{{1, -0.2, 0.4}, {2, 0.1, 0.5}, 1.4};
    CHECK(all[0] == "# gamma=1.3999999999999999");
    CHECK(all[1] == "# time=0.14999999999999999");
    CHECK(constant(all[2], "p_star") == solution.star().p);
    CHECK(constant(all[3], "v_star") == solution.star().v);
    CHECK(constant(all[4], "rho_star_left") == solution.star().rho_left);
    CHECK(constant(all[5], "rho_star_right") == solution.star().rho_right);
    CHECK(all[6] == "x,rho,v,p,u,lorentz");
    const RelativisticRiemann::Point at = solution.at(0.1, 0.15);
    const auto row = numbers(all[9]);
    REQUIRE(row.size() == 6);
    CHECK(std::vector<double>{row.begin(), row.begin() + 5} ==
          std::vector<double>{0.1, at.rho, at.v, at.p, at.u});
    CHECK(row[5] == Approx(1 / std::sqrt(1 - at.v * at.v)).epsilon(1e-14));
    CHECK(run("relativistic-riemann --left 10,0,13.33 --right 1,0,1e-8 --time 0.4 --points 9").text ==
          run("relativistic-riemann --points 9 --window -0.5,0.5").text);
    check_refused({
        {"relativistic-riemann", "--x", "--points"},
        {"relativistic-riemann --x 0 --left 1,0", "--left", "3"},
        {"relativistic-riemann --x 0 --left 1,1,1", "--left: velocity 1 ", "> -1 and < 1"},
        {"relativistic-riemann --x 0 --velocity lorentz --left 1,0.5,1", "--left", "Lorentz factor"},
        {"relativistic-riemann --x 0 --velocity rapidity --left 1,0.5,1", "--velocity", "four-velocity"},
        {"relativistic-riemann --x 0 --right 1,-1.5,1", "--right: velocity -1.5 ", "> -1 and < 1"},
        {"relativistic-riemann --x 0 --left -1,0,1", "--left: density -1 ", "1e-100"},
        {"relativistic-riemann --x 0 --left 1e-101,0,1", "--left: density 1e-101 ",
         "1e-100 and above, and 0"},
        {"relativistic-riemann --x 0 --right 1,0,-2", "--right: pressure -2 ", "0 and above"},
        {"relativistic-riemann --x 0 --right 0,0,1", "--right: pressure 1 ", "vacuum"},
        {"relativistic-riemann --x 0 --right 1,0,1e101", "--right", "1e100"},
        {"relativistic-riemann --x 0 --right 1,0,nan", "--right", "nan"},
        {"relativistic-riemann --x 0 --left 0,0,0 --right 0,0,0", "--right: density 0 ", "vacuum"},
        {"relativistic-riemann --x 0 --gamma 1", "--gamma", "<= 2"},
        {"relativistic-riemann --x 0 --gamma 2.1", "--gamma", "<= 2"},
        {"relativistic-riemann --x 0 --time -1", "--time", ">= 0"},
    });
    CHECK(run("relativistic-riemann --x 0,0.9 --right 1,-0.9,0 --left 0,0,0").status == 0);
}
