// The scene `wedge` as a reader calls it.
#include "tests/program.hpp"

using namespace program;

// Fails for every check that is left out.
TEST_CASE("wedge: bad options are refused in one line that names them") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    check_refused("--scene wedge --angle 30" + out, 2, "22.97 (theta_max at Mach 2)");
    check_refused("--scene wedge --mach 1" + out, 2, "--mach");
    check_refused("--scene wedge --cells 4" + out, 2, "--cells");
    check_refused("--scene wedge --walls glass" + out, 2, "mirrors");
    check_refused("--scene wedge --method conducting" + out, 2, "alpha-beta-twice");
    check_refused("--scene wedge --method godunov --alpha 1" + out, 2, "alpha-beta");
    CHECK(folder.files() == 0);
}

// Fails for other columns, and for a run that has not measured the shock.
TEST_CASE("wedge: it leaves a profile and results; without mirrors it stops with a typed error") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    const Outcome run_of_it = run("--scene wedge --cells 12 --times 0.6" + out);
    INFO(run_of_it.text);
    REQUIRE(run_of_it.status == 0);
    CHECK(run_of_it.text.find("shock_angle,") != std::string::npos);
    CHECK(run_of_it.text.find("mach_behind_shock,") != std::string::npos);
    CHECK(table(folder.path / "profile.csv").find("x,y,rho,v_x,v_y,p,mach\n") == 0);
    CHECK(run("--scene wedge --cells 12 --walls none" + out).status == 3);
}
