// The chapter's program as a reader calls it.
#include "tests/program.hpp"

using namespace program;

TEST_CASE("bad options are refused in one line that names them") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    check_refused("--scene cylinder --particles 5" + out, 2, "--particles");
    check_refused("--scene cylinder --time 0.5" + out, 2, "--time");
    check_refused("--scene cylinder --time 100" + out, 2, "--time");
    check_refused("--scene cylinder --sound-speed-squared 1" + out, 2, "--sound-speed-squared");
    check_refused("--scene cylinder --radius 0" + out, 2, "--radius");
    check_refused("--scene cylinder --method hexagon" + out, 2, "hexagonal");
    check_refused("--scene gubser --q 0" + out, 2, "--q");
    check_refused("--scene gubser --radius 3" + out, 2, "--scene cylinder");
    check_refused("--scene event --spots 0" + out, 2, "--spots");
    CHECK(folder.files() == 0);
}

TEST_CASE("scenes leave a profile, a figure and results, the same for one and two threads") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    const std::string cylinder = "x,y,r,temperature,exact_temperature,u_r,exact_u_r\n";
    for (const auto& [scene, columns] :
         {std::pair{std::string{"--scene cylinder --particles 200 --time 2"}, cylinder},
          {"--scene cylinder --particles 200 --time 2 --method relaxed", cylinder},
          {"--scene gubser --particles 200 --time 1.2",
           std::string{"x,y,r,temperature,exact_temperature,u_r,exact_u_r,eps,exact_eps\n"}},
          {"--scene event --particles 300 --time 2", std::string{"x,y,temperature,u_x,u_y\n"}}}) {
        INFO(scene);
        REQUIRE(run("--threads 1 " + scene + out).status == 0);
        const std::string profile = table(folder.path / "profile.csv");
        CHECK(profile.find(columns) == 0);
        REQUIRE(run("--threads 2 " + scene + out).status == 0);
        CHECK(table(folder.path / "profile.csv") == profile);
    }
}
