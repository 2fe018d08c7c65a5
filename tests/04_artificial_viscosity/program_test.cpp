// The chapter's program as a reader calls it.
#include "tests/program.hpp"

using namespace program;

TEST_CASE("bad options are refused in one line that names them") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    check_refused("--only sods" + out, 2, "sod");
    check_refused("--scene tube --gamma 1" + out, 2, "--gamma");
    check_refused("--scene tube --jitter 0.6" + out, 2, "0..0.49");
    check_refused("--scene tube --left 1,0" + out, 2, "--left");
    check_refused("--scene tube --left 1,0,nan" + out, 2, "--left");
    check_refused("--scene tube --left 0,0,1" + out, 2, "--left");
    check_refused("--scene tube --window 0,1" + out, 2, "--diaphragm");
    check_refused("--scene tube --left 1e-6,0,1 --right 1,0,1 --particles 200" + out, 2, "--spacing even");
    check_refused("--scene tube --h-over-dx 0.3 --kernel cubic" + out, 2, "0.5..8");
    check_refused("--scene tube --h-over-dx 0.6 --kernel cubic" + out, 2, "above 0.6667");
    check_refused("--scene tube --right -1,0,1" + out, 2, "--right");
    check_refused("--scene tube --left 0,0,0 --right 0,0,0" + out, 2, "vacuum");
    check_refused("--scene tube --method alpha" + out, 2, "alpha-beta");
    check_refused("--scene tube --particles 5" + out, 2, "--particles");
    check_refused("--scene tube --method signal --alpha 1" + out, 2, "monaghan-gingold, alpha-beta");
    check_refused("--scene tube --kernel cubics" + out, 2, "--kernel");
    check_refused("--only wave --gamma 3" + out, 2, "--scene tube");
    check_refused("--scene tube --all-runs" + out, 2, "--only survival");
    CHECK(folder.files() == 0);
}

TEST_CASE("a tube leaves a profile, a figure and results, the same for one and two threads") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    for (const std::string scene :
         {"--particles 60", "--left=-0,0,0 --right 1,0,1 --particles 40 --time 0.1",
          "--left 1,-1,1e-3 --right 1,1,1e-3 --particles 40 --method price --jitter 0.2 --seed 3"}) {
        const Outcome first = run("--scene tube --threads 1 " + scene + out);
        INFO(scene << "\n" << first.text);
        REQUIRE(first.status == 0);
        for (const std::string quantity : {"l1_rho,", "l1_v,", "l1_p,", "energy_drift,", "steps,", "pairs,"})
            CHECK(first.text.find(quantity) != std::string::npos);
        const std::string profile = table(folder.path / "profile.csv");
        CHECK(profile.find("x,rho,v,p,u,exact_rho,exact_v,exact_p,exact_u\n") == 0);
        // Options, given or not, and what the method has of its own: each once.
        const std::string whole = read(folder.path / "profile.csv");
        for (const std::string line :
             {"# gamma=1.4\n", "# method=", "# kernel=", "# h-over-dx=", "# beta="}) {
            INFO(whole.substr(0, 600));
            const auto place = whole.find(line);
            REQUIRE(place != std::string::npos);
            CHECK(whole.find(line, place + 1) == std::string::npos);
        }
        REQUIRE(run("--scene tube --threads 2 " + scene + out).status == 0);
        CHECK(table(folder.path / "profile.csv") == profile);
    }
}

TEST_CASE("the list of methods marks the recommended one") {
    const Folder folder;
    const Outcome outcome = run("--scene tube --method list --out " + folder.path.string());
    REQUIRE(outcome.status == 0);
    CHECK(outcome.text.find("alpha-beta\n") != std::string::npos);
    CHECK(outcome.text.find("reconstructed (recommended)\n") != std::string::npos);
}

TEST_CASE("without viscosity a strong blast stops with status 3 and leaves no figure") {
    const Folder folder;
    check_refused(
        "--scene tube --left 1,0,3000 --right 1,0,1e-7 --gamma 1.67 --time 0.006 --particles 60 "
        "--method none --out " +
            folder.path.string(),
        3, "unphysical state at t = ");
    CHECK(folder.files() == 0);
}

TEST_CASE("a method's parameters, its kernel and its h are options, and each of them acts") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    std::vector<std::string> profiles;
    for (const std::string change : {"", "--alpha 0.5", "--beta 1", "--kernel quintic", "--h-over-dx 1.5"}) {
        INFO(change);
        REQUIRE(run("--scene tube --particles 40 --method alpha-beta " + change + out).status == 0);
        const std::string profile = table(folder.path / "profile.csv");
        CHECK(std::find(profiles.begin(), profiles.end(), profile) == profiles.end());
        profiles.push_back(profile);
    }
}
