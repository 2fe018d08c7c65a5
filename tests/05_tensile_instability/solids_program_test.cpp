// The scenes of elastic solids as a reader calls them.
#include "tests/program.hpp"

using namespace program;

TEST_CASE("solids: bad options are refused in one line that names them") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    check_refused("--scene wheel --method jauman" + out, 2, "jaumann");
    check_refused("--scene wheel --particles 7" + out, 2, "8..200");
    check_refused("--scene wheel --rim 0.6" + out, 2, "--rim");
    check_refused("--scene wheel --shear 1.5" + out, 2, "0.01..1.4");
    check_refused("--scene wheel --turns nan" + out, 2, "--turns");
    check_refused("--scene wheel --speed 1" + out, 2, "elastic-disc");
    check_refused("--scene elastic-disc --speed 0" + out, 2, "--speed");
    check_refused("--scene elastic-disc --particles 49" + out, 2, "50..20000");
    check_refused("--scene elastic-disc --time -1" + out, 2, "--time");
    CHECK(folder.files() == 0);
}

TEST_CASE("solids: scenes leave a profile and results, the same for one and two threads") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    const std::pair<std::string, std::string> scenes[] = {
        {"--scene wheel --particles 10 --turns 0.2 --method jaumann", "turns,angular_momentum_change\n"},
        {"--scene elastic-disc --particles 100 --time 2", "x,y,start_r\n"}};
    for (const auto& [scene, header] : scenes) {
        const Outcome first = run(scene + " --threads 1" + out);
        INFO(scene << "\n" << first.text);
        REQUIRE(first.status == 0);
        CHECK(first.text.find("momentum_drift,") != std::string::npos);
        const std::string profile = table(folder.path / "profile.csv");
        CHECK(profile.find(header) == 0);
        REQUIRE(run(scene + " --threads 2" + out).status == 0);
        CHECK(table(folder.path / "profile.csv") == profile);
    }
}
