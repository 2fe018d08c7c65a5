// The chapter's program as a reader calls it.
#include "tests/program.hpp"

using namespace program;

TEST_CASE("bad options of lattice-growth are refused in one line that names them") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    check_refused("--scene lattice-growth --kernel cubik" + out, 2, "cubic");
    check_refused("--scene lattice-growth --kernel cubic --h-over-dx 0.5" + out, 2, "above 0.5");
    check_refused("--scene lattice-growth --h-over-dx 9" + out, 2, "0.5..8");
    check_refused("--scene lattice-growth --pressure nan" + out, 2, "--pressure");
    check_refused("--scene lattice-growth --tension-x inf" + out, 2, "--tension-x");
    CHECK(folder.files() == 0);
}

TEST_CASE("lattice-growth prints CSV and nothing else, for all kernels") {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    const Outcome cubic = run("--scene lattice-growth --kernel cubic --h-over-dx 1.2 --pressure -0.5" + out);
    REQUIRE(cubic.status == 0);
    CHECK(cubic.text.rfind("pressure,growth,kx,ky\n-0.5,1.19335539893356", 0) == 0);
    CHECK(cubic.text.find(",3.14159265358979") != std::string::npos);
    CHECK(lines(cubic.text) == 2);
    for (const std::string kernel : {"gaussian", "super-gaussian", "cubic", "quartic", "quintic", "lucy",
                                     "wendland-c2", "wendland-c4", "wendland-c6"}) {
        const Outcome one =
            run("--scene lattice-growth --h-over-dx 1.4 --pressure=-1,0,1 --kernel " + kernel + out);
        INFO(kernel << "\n" << one.text);
        CHECK(one.status == 0);
        CHECK(lines(one.text) == 4);
    }
    CHECK(folder.files() == 0);
}
