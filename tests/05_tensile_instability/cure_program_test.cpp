// The scene of the cures as a reader calls it.
#include "tests/program.hpp"

using namespace program;

TEST_CASE("bad options of a cure are refused in one line that names them") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    check_refused("--scene cure --method cork" + out, 2, "balanced");
    check_refused("--scene cure --pressure -3" + out, 2, "--pressure");
    check_refused("--scene cure --particles 3" + out, 2, "--particles");
    check_refused("--scene cure --jitter 0.6" + out, 2, "0..0.49");
    check_refused("--scene cure --time 0" + out, 2, "--time");
    check_refused("--scene cure --method none --alpha 1" + out, 2, "--alpha");
    check_refused("--scene cure --method balanced --width 1" + out, 2, "--width");
    CHECK(folder.files() == 0);
}

TEST_CASE("every cure runs, and leaves its merits and a profile that are the same for two threads") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    const Outcome list = run("--scene cure --method list" + out);
    REQUIRE(list.status == 0);
    CHECK(list.text.find("balanced (recommended)\n") != std::string::npos);
    std::istringstream lines{list.text};
    int methods = 0;
    for (std::string name; lines >> name;) {
        if (name.front() == '(') continue;
        ++methods;
        const std::string scene = "--scene cure --particles 10 --time 1 --seed 4 --method " + name;
        const Outcome first = run(scene + " --threads 1" + out);
        INFO(first.text);
        REQUIRE(first.status == 0);
        for (const std::string quantity :
             {"growth,", "sound_speed,", "shear_speed,", "smallest_distance,", "order,", "momentum_drift,",
              "energy_drift,", "nanoseconds_per_pair,"})
            CHECK(first.text.find(quantity) != std::string::npos);
        const std::string profile = table(folder.path / "profile.csv");
        CHECK(profile.find("x,y,v_x,v_y\n") == 0);
        REQUIRE(run(scene + " --threads 2" + out).status == 0);
        CHECK(table(folder.path / "profile.csv") == profile);
    }
    CHECK(methods == 19);
}
