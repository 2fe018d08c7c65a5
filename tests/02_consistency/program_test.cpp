// The chapter's program as a reader calls it.
#include "tests/program.hpp"

using namespace program;

TEST_CASE("bad options are refused in one line that names them") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    check_refused("--only moment" + out, 2, "moments");
    check_refused("--jitter 0.6" + out, 2, "0..0.5");
    check_refused("--jitter nan" + out, 2, "--jitter");
    check_refused("--h-over-dx 0" + out, 2, "0.5..8");
    check_refused("--particles 5000" + out, 2, "8..4096");
    check_refused("--kernel gaussian" + out, 2, "cubic");
    check_refused("--volumes full" + out, 2, "summed");
    check_refused("--scene interpolate --dimension 3" + out, 2, "--dimension");
    check_refused("--scene interpolate --dimension 2 --particles 2000" + out, 2, "8..1024");
    check_refused("--scene slab" + out, 2, "interpolate");
    CHECK(folder.files() == 0);
}

TEST_CASE("an option that a figure or scene does not take is refused, naming those that do") {
    // Fails if a declared option is ignored by what was chosen.
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    check_refused("--kernel cubic" + out, 2,
                  "a run of all figures does not take it; allowed with --only moments");
    check_refused("--only moments --jitter 0.1" + out, 2, "the figure moments does not take it");
    check_refused("--only maps --particles 32" + out, 2, "allowed with --scene interpolate");
    check_refused("--only step --kernel cubic" + out, 2, "the figure step does not take it");
    check_refused("--only convergence --function line" + out, 2, "allowed with --scene interpolate");
    CHECK(folder.files() == 0);
}

TEST_CASE("a reader's scene: its profile, its figure, its errors, and nothing else") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    const std::string scene =
        "--scene interpolate --arrangement random --particles 30 --dimension 2 --function line";
    const Outcome first = run(scene + " --threads 1" + out);
    REQUIRE(first.status == 0);
    CHECK(folder.files() == 4);  // png, its csv, profile.csv, results.csv
    const std::string profile = table(folder.path / "profile.csv");
    CHECK(lines(profile) == 901);
    CHECK(profile.rfind(
              "x,y,sph,sph_slope,differences_slope,by-axes_slope,cspm,cspm_slope,linear_slope,fit,fit_slope,"
              "exact,exact_slope\n",
              0) == 0);
    CHECK(first.text.find("interpolate,cspm,900,l2_slope,") != std::string::npos);
    REQUIRE(run(scene + " --threads 2" + out).status == 0);
    CHECK(table(folder.path / "profile.csv") == profile);
    REQUIRE(run(scene + " --seed 2" + out).status == 0);
    CHECK(table(folder.path / "profile.csv") != profile);
}

TEST_CASE("a constant has no relative error of its slope, and the scene goes on") {
    const Folder folder;
    const Outcome outcome = run("--scene interpolate --function constant --out " + folder.path.string());
    CHECK(outcome.status == 0);
    CHECK(outcome.text.find("l2_f") != std::string::npos);
    CHECK(outcome.text.find("l2_slope") == std::string::npos);
}
