// The chapter's program as a reader calls it.
#include "tests/program.hpp"

using namespace program;

TEST_CASE("bad options are refused in one line that names them") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    check_refused("--only stil" + out, 2, "still");
    check_refused("--scene burgers --method sfmp" + out, 2, "frame-4");
    check_refused("--scene burgers --motion still --method frame-4" + out, 2, "fdm-4");
    check_refused("--scene burgers --motion moving --method fdm" + out, 2, "remesh-m4");
    check_refused("--scene burgers --boundary open" + out, 2, "--boundary");
    check_refused("--scene burgers --boundary frozen" + out, 2, "allowed: mirror");
    check_refused("--scene burgers --viscosity 0" + out, 2, "--viscosity");
    check_refused("--scene burgers --particles 5" + out, 2, "8..2000");
    check_refused("--scene burgers --time 0" + out, 2, "--time");
    check_refused("--scene burgers --kernel cubik" + out, 2, "cubic");
    check_refused("--scene estimate --order 4 --member fpm" + out, 2, "allowed: 1, 2");
    check_refused("--scene estimate --order 3" + out, 2, "1, 2, 4");
    check_refused("--scene estimate --dimension 2 --member brookshaw" + out, 2, "--member");
    check_refused("--scene estimate --dimension 3 --particles 100" + out, 2, "8..48");
    check_refused("--only still --viscosity 1" + out, 2, "--scene burgers");
    CHECK(folder.files() == 0);
}

TEST_CASE("scenes leave a profile, a figure and results, the same for one and two threads") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    for (const std::string scene :
         {"burgers --particles 40", "burgers --motion still --particles 41 --viscosity 1 --time 0.2",
          "burgers --method remesh-fit --particles 50",
          "burgers --method fpm --boundary frozen --viscosity 0.1", "estimate --member fpm",
          "estimate --dimension 2 --particles 16"}) {
        const Outcome first = run("--scene " + scene + " --threads 1" + out);
        INFO(scene << "\n" << first.text);
        REQUIRE(first.status == 0);
        const std::string profile = table(folder.path / "profile.csv");
        CHECK(profile.find(scene[0] == 'b' ? "x,u,exact_u\n" : "exact_f") != std::string::npos);
        CHECK(lines(profile) >= 41);
        REQUIRE(run("--scene " + scene + " --threads 2" + out).status == 0);
        CHECK(table(folder.path / "profile.csv") == profile);
    }
}

TEST_CASE("the list of methods marks the recommended one of each motion") {
    CHECK(run("--scene burgers --method list").text.find("frame-4 (recommended)\n") != std::string::npos);
    CHECK(run("--scene burgers --motion still --method list").text.find("sfpm-4 (recommended)\n") !=
          std::string::npos);
}

TEST_CASE("crossings are told, and a state without meaning stops with status 3") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    const Outcome crossed = run("--scene burgers --method sfpm --viscosity 0.02" + out);
    CHECK(crossed.status == 0);
    CHECK(crossed.text.find("warning: particles have crossed, first at t = 0.56") != std::string::npos);
    check_refused(
        "--scene burgers --motion still --method fpm --boundary none --viscosity 1 --particles 41" + out, 3,
        "unphysical state at t = 0.2");
}
