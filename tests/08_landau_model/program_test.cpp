// The chapter's program as a reader calls it.
#include "tests/program.hpp"

using namespace program;

TEST_CASE("bad options are refused in one line that names them") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    check_refused("--only slabs" + out, 2, "slab");
    check_refused("--scene slab --particles 5" + out, 2, "--particles");
    check_refused("--scene slab --time -1" + out, 2, "--time");
    check_refused("--scene slab --time 1e7" + out, 2, "--time");
    check_refused("--scene slab --method fixed" + out, 2, "fixed-20");
    check_refused("--scene tube --gamma 2.1" + out, 2, "--gamma");
    check_refused("--scene tube --left 1,1,1" + out, 2, "velocity");
    check_refused("--scene tube --left 1,0,1e-14" + out, 2, "pressure");
    check_refused("--scene tube --left 0,0,1" + out, 2, "--left");
    check_refused("--scene tube --window 0,1" + out, 2, "--diaphragm");
    check_refused("--scene tube --velocity lorentz --left 1,0.5,1" + out, 2, "Lorentz factor");
    check_refused("--scene slab --method narrow --h-over-dx 0.6" + out, 2, "above 0.75");
    check_refused("--scene tube --left 1e-6,0,1 --right 1,0,1 --particles 200" + out, 2, "--spacing even");
    check_refused("--scene tube --h-over-dx 0.3 --kernel cubic" + out, 2, "0.5..8");
    check_refused("--scene tube --h-over-dx 0.6 --kernel cubic" + out, 2, "above 0.6667");
    check_refused("--scene tube --left 0,0,0 --right 0,0,0" + out, 2, "vacuum");
    check_refused("--scene tube --method alpha" + out, 2, "chow-monaghan");
    check_refused("--scene tube --method chow-monaghan --cap 0.1" + out, 2, "reconstructed");
    check_refused("--scene slab --gamma 1.5" + out, 2, "--scene tube");
    check_refused("--only edge --particles 100" + out, 2, "--scene");
    CHECK(folder.files() == 0);
}

TEST_CASE("scenes leave a profile, a figure and results, the same for one and two threads") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    const std::string tube = "x,rho,v,p,u,exact_rho,exact_v,exact_p,exact_u,lorentz,exact_lorentz\n";
    const std::string slab = "x,s_star,exact_s_star,eps,exact_eps,rapidity,exact_rapidity,v,exact_v\n";
    for (const auto& [scene, columns] :
         {std::pair{std::string{"--scene slab --particles 60 --time 2"}, slab},
          {"--scene slab --particles 60 --time 3 --method fixed-10", slab},
          {"--scene tube --particles 60", tube},
          {"--scene tube --left=-0,0,0 --right 1,0,1 --particles 40 --time 0.1", tube},
          {"--scene tube --left 1,0.9,1 --right 1,-0.9,1 --particles 40 --jitter 0.2 --seed 3", tube}}) {
        const Outcome first = run("--threads 1 " + scene + out);
        INFO(scene << "\n" << first.text);
        REQUIRE(first.status == 0);
        for (const std::string quantity : {"energy_drift,", "momentum_drift,", "steps,", "pairs,"})
            CHECK(first.text.find(quantity) != std::string::npos);
        const std::string profile = table(folder.path / "profile.csv");
        CHECK(profile.find(columns) == 0);
        REQUIRE(run("--threads 2 " + scene + out).status == 0);
        CHECK(table(folder.path / "profile.csv") == profile);
    }
}

TEST_CASE("the lists of methods mark the recommended one") {
    const Folder folder;
    const std::string out = " --method list --out " + folder.path.string();
    CHECK(run("--scene tube" + out).text.find("reconstructed (recommended)\n") != std::string::npos);
    CHECK(run("--scene slab" + out).text.find("narrow-graded (recommended)\n") != std::string::npos);
}

TEST_CASE("without dissipation a blast stops with status 3 and leaves no figure") {
    const Folder folder;
    check_refused("--scene tube --particles 60 --method none --out " + folder.path.string(), 3,
                  "unphysical state at t = ");
    CHECK(folder.files() == 0);
}
