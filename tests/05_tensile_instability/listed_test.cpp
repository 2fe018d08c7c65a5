// Only what a scene lists: no column, and no pass, for what it does not.
#include <catch2/catch.hpp>
#include <map>

#include "chapters/05_tensile_instability/scenes/listed.hpp"
#include "chapters/05_tensile_instability/scenes/solid.hpp"

using namespace sph;
using namespace sph::tensile;

TEST_CASE("an effect that is listed brings its columns, and no others") {
    std::map<std::string, report::ListedPass> passes;
    for (auto& [label, pass] : listed_passes()) passes.emplace(label, std::move(pass));
    const auto columns = [&](const char* label) { return passes.at(label).columns; };
    // Fails if an effect names a column that it does not use, or if a pass holds one that nobody names.
    CHECK(columns("pressure (5.2)") == 2 + 2 + 3);                                  // x, dv_dt; m, rho, p
    CHECK(columns("pressure and artificial stress") == columns("pressure (5.2)"));  // reads what is there
    CHECK(columns("pressure and XSPH") == columns("pressure (5.2)") + 2 + 2);       // v, v_x
    CHECK(columns("pressure and background") == columns("pressure (5.2)") + 1);     // phi
    CHECK(columns("stress (5.10)") == 2 + 2 + 2 + 4);                               // x, dv_dt; m, rho; sigma
    CHECK(columns("stress and artificial stress (5.15)") == columns("stress (5.10)") + 4);  // R
    // v, V, rho, S, dS_dt, drho_dt; grad v is summed and not stored, and so is B where it is corrected.
    CHECK(columns("Hooke's law (5.9)") == 2 + 2 + 1 + 1 + 4 + 4 + 1);
    CHECK(columns("Hooke's law with corrected gradients") == columns("Hooke's law (5.9)"));
    for (const auto& [label, pass] : passes) {
        INFO(label);
        CHECK_NOTHROW(pass.pass());
        CHECK(pass.particles == 64 * 64);
        CHECK(pass.pairs > 18 * pass.particles);  // measured 18.1 a particle: 2.4 spacings around
    }
}

TEST_CASE("a solid holds only what its law lists") {
    const SolidSetup setup{.n = 4, .matter = {1, 0.22, 1}};
    const auto printed = make_solid(setup, solid_methods()["jaumann"]);
    CHECK(!printed->has<ArtificialStress>());
    CHECK(!printed->has<TransportVelocity>());
    CHECK(make_solid(setup, solid_methods()["artificial-stress"])->has<ArtificialStress>());
    CHECK(make_solid(setup, solid_methods()["strong-xsph"])->has<TransportVelocity>());
    CHECK(!make_solid(setup, solid_methods()["total-lagrangian"])->has<DeviatoricStress>());
}
