// The chapter's program as a reader calls it: bad input gets one line and the right exit status.
#include "tests/program.hpp"

using namespace program;

TEST_CASE("bad options are refused in one line that names them") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    check_refused("--only kernel" + out, 2, "kernels");  // the nearest
    check_refused("--onyl kernels" + out, 2, "--only");
    check_refused("--threads 0" + out, 2, "1..256");
    check_refused("--jitter nan" + out, 2, "--jitter");
    check_refused("--jitter inf" + out, 2, "--jitter");
    check_refused("--h-over-dx -1" + out, 2, "--h-over-dx");
    check_refused("--h-over-dx 1.2x" + out, 2, "--h-over-dx");
    check_refused("--particles 0" + out, 2, "--particles");
    check_refused("--kernel cubik" + out, 2, "cubic");
    check_refused("--scene interpolate --dimension 4" + out, 2, "--dimension");
    check_refused("--seed -1" + out, 2, "--seed");
    CHECK(folder.files() == 0);
}

TEST_CASE("an option that a figure or scene does not take is refused, naming those that do") {
    // Fails if a declared option is ignored by what was chosen.
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    check_refused("--kernel quintic" + out, 2,
                  "a run of all figures does not take it; allowed with --only inter");
    check_refused("--only kernels --kernel quintic" + out, 2, "the figure kernels does not take it");
    check_refused("--only convergence --particles 64" + out, 2,
                  "--only interpolation, --only map, --scene inter");
    check_refused("--only map --dimension 2" + out, 2, "--scene interpolate, --scene kernel");
    check_refused("--only second-derivatives --arrangement even" + out, 2, "--scene interpolate");
    check_refused("--scene kernel --jitter 0.1" + out, 2, "the scene kernel does not take it");
    check_refused("--scene interpolate --only map" + out, 2, "--scene");
    CHECK(folder.files() == 0);
}

TEST_CASE("what cannot be written is said before anything is computed") {
    const Folder folder;
    check_refused("--only kernels --out /dev/null/x", 4, "/dev/null/x");
    check_refused("--only kernels --out " + folder.path.string(), 4, "fonts-dejavu-core",
                  "SPH_FONT=/nonexistent.ttf");
    CHECK(folder.files() == 0);
    // A pipe in the place of the results: reading it would wait for ever.
    REQUIRE(mkfifo((folder.path / "results.csv").c_str(), 0600) == 0);
    check_refused("--quick --only kernels --out " + folder.path.string(), 4, "results.csv");
    // Standard output on a full disk.
    const Outcome full = run("--scene kernel --out " + folder.path.string() + " > /dev/full");
    CHECK(full.status == 4);
}

TEST_CASE("one figure of a run: its picture, its data, its results, and nothing else") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    REQUIRE(run("--quick --only integral-error --threads 1" + out).status == 0);
    CHECK(folder.files() == 3);
    const std::string png = read(folder.path / "integral-error.png"),
                      csv = read(folder.path / "integral-error.csv");
    CHECK(png.size() > 10000);
    CHECK(read(folder.path / "results.csv").rfind("scene,method,n,quantity,value,unit\n", 0) == 0);
    // The same bytes for two threads and another folder.
    REQUIRE(run("--quick --only integral-error --threads 2" + out + "/again").status == 0);
    CHECK(read(folder.path / "again" / "integral-error.png") == png);
    CHECK(read(folder.path / "again" / "integral-error.csv") == csv);
    // A second figure keeps the first one's results.
    REQUIRE(run("--quick --only map" + out).status == 0);
    const std::string results = read(folder.path / "results.csv");
    CHECK(results.find("integral-error,cubic,1,rate_wave") != std::string::npos);
    CHECK(results.find("map,cubic,1024,l2_value_map") != std::string::npos);
    // So does a scene.
    REQUIRE(run("--scene interpolate" + out).status == 0);
    CHECK(table(folder.path / "results.csv").rfind(results, 0) == 0);
}

TEST_CASE("a reader's scene depends on its options and on nothing else") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    const std::string scene = "--scene interpolate --kernel quintic --particles 20 --dimension 2 --seed 5";
    REQUIRE(run(scene + " --threads 1" + out).status == 0);
    const std::string profile = table(folder.path / "profile.csv");
    CHECK(lines(profile) == 401);
    CHECK(profile.rfind("x,y,A,dA_dx,laplacian,exact_A,exact_dA_dx,exact_laplacian\n", 0) == 0);
    REQUIRE(run(scene + " --threads 2" + out).status == 0);
    CHECK(table(folder.path / "profile.csv") == profile);
    REQUIRE(run("--scene interpolate --kernel quintic --particles 20 --dimension 2 --seed 6" + out).status ==
            0);
    CHECK(table(folder.path / "profile.csv") != profile);
}

TEST_CASE("the table of a kernel on standard output") {
    const Outcome table = run("--scene kernel --kernel cubic --dimension 3");
    CHECK(table.status == 0);
    CHECK(lines(table.text) == 202);
    CHECK(table.text.rfind("q,W,dW_dr,d2W_dr2,F,dW_dh\n0,0.318309886183790", 0) == 0);  // 1/pi at the centre
}
