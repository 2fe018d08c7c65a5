// The chapter's program as a reader calls it.
#include "tests/program.hpp"

using namespace program;

TEST_CASE("bad options are refused in one line that names them") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    check_refused("--only waves" + out, 2, "wave");
    check_refused("--gamma 0.9" + out, 2, "1..100");
    check_refused("--k-dx 1,nan" + out, 2, "--k-dx");
    check_refused("--h-over-dx 0" + out, 2, "0.5..8");
    check_refused("--resolution own" + out, 2, "consistent-h");
    check_refused("--scene star --gamma 1" + out, 2, "--gamma");
    check_refused("--scene star --resolution continuity" + out, 2, "--resolution");
    check_refused("--scene star --particles 2000" + out, 2, "8..1000");
    check_refused("--scene wave --kernel cubik" + out, 2, "cubic");
    check_refused("--scene wave --amplitude 0.3" + out, 2, "--scene star");
    check_refused("--only wave --gamma 3" + out, 2, "the figure wave does not take it");
    check_refused("--kernel quintic" + out, 2, "--scene wave");
    check_refused("--scene slab" + out, 2, "dispersion");
    // Particles without neighbours: h would shrink for ever, and Omega is 0/0.
    check_refused("--scene wave --h-over-dx 0.6" + out, 2, "above 0.6667");
    check_refused("--scene star --h-over-dx 0.66 --time 1" + out, 2, "above 0.6667");
    check_refused("--scene rarefaction --h-over-dx 0.5" + out, 2, "above 0.6667");
    check_refused("--scene dispersion --kernel cubic --h-over-dx 0.5" + out, 2, "above 0.5");
    CHECK(folder.files() == 0);
}

TEST_CASE("the scene dispersion prints CSV and nothing else") {
    const Folder folder;
    const Outcome outcome =
        run("--scene dispersion --kernel cubic --h-over-dx 1.2 --gamma 1.66666666666666667 "
            "--k-dx 0.09817477042468103,1.5707963267948966 --out " +
            folder.path.string());
    REQUIRE(outcome.status == 0);
    CHECK(outcome.text.rfind("k_dx,omega2_constant_h,omega2_variable_h\n0.098174770424681", 0) == 0);
    CHECK(lines(outcome.text) == 3);
    CHECK(outcome.text.find(",0.0102193412199") != std::string::npos);
    CHECK(outcome.text.find(",2.62680602107") != std::string::npos);
    CHECK(folder.files() == 0);
}

TEST_CASE("scenes leave a profile, a figure and results, the same for one and two threads") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    for (const std::string scene : {"wave --particles 32", "star --particles 40 --time 2 --gamma 2",
                                    "rarefaction --particles 60 --gamma 1.4"}) {
        const Outcome first = run("--scene " + scene + " --threads 1" + out);
        INFO(scene << "\n" << first.text);
        REQUIRE(first.status == 0);
        CHECK(first.text.find("l1_v,") != std::string::npos);
        const std::string profile = table(folder.path / "profile.csv");
        CHECK(lines(profile) >= 33);
        CHECK(profile.find("exact_v") != std::string::npos);
        REQUIRE(run("--scene " + scene + " --threads 2" + out).status == 0);
        CHECK(table(folder.path / "profile.csv") == profile);
    }
}

TEST_CASE("a star that is not found stops with status 3 and writes no figure") {
    const Folder folder;
    check_refused(
        "--scene star --gamma 1.4 --resolution fixed-h --particles 100 --out " + folder.path.string(), 3,
        "star at rest");
    CHECK(folder.files() == 0);
}
