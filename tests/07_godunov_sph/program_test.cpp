// The chapter's program as a reader calls it.
#include "tests/program.hpp"

using namespace program;

TEST_CASE("bad options are refused in one line that names them") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    check_refused("--scene tube --method alpha" + out, 2, "inutsuka");
    check_refused("--scene wave --particles 3" + out, 2, "--particles");
    check_refused("--scene wave --method inutsuka --jump 1" + out, 2, "godunov");
    check_refused("--scene wave --jitter 0.1" + out, 2, "--scene tube");
    check_refused("--scene sedov --dimension 4" + out, 2, "--dimension");
    check_refused("--scene sedov --dimension 3 --method inutsuka" + out, 2, "godunov");
    check_refused("--scene sedov --particles 3" + out, 2, "--particles");
    CHECK(folder.files() == 0);
}

TEST_CASE("a blast leaves a profile and results") {
    const Folder folder;
    const Outcome blast = run("--scene sedov --dimension 2 --particles 12 --out " + folder.path.string());
    INFO(blast.text);
    REQUIRE(blast.status == 0);
    CHECK(blast.text.find("shock_radius,") != std::string::npos);
    CHECK(table(folder.path / "profile.csv").find("r,rho,v,p\n") == 0);
}

TEST_CASE("the wave leaves a profile and results, the same for one and two threads") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    const Outcome first = run("--scene wave --particles 32 --threads 1" + out);
    INFO(first.text);
    REQUIRE(first.status == 0);
    CHECK(first.text.find("l1_v,") != std::string::npos);
    const std::string profile = table(folder.path / "profile.csv");
    CHECK(profile.find("x,v,exact_v\n") == 0);
    REQUIRE(run("--scene wave --particles 32 --threads 2" + out).status == 0);
    CHECK(table(folder.path / "profile.csv") == profile);
}
