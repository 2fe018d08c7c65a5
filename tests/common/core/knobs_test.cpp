// What may be turned at an effect becomes parameters, and these become an effect again.
#include "common/core/knobs.hpp"

#include <catch2/catch.hpp>

#include "common/app/error.hpp"

using namespace sph;

namespace {

struct Viscosity {
    double alpha = 1, beta = 2;
    static constexpr auto knobs() {
        return std::tuple{Knob{"alpha", &Viscosity::alpha, {0, 10}, "strength of the linear term"},
                          Knob{"beta", &Viscosity::beta, app::non_negative, "of the quadratic one"}};
    }
};
struct Conduction {
    double alpha = 0.5;  // shared with the viscosity
    double kappa = 0.1;
    static constexpr auto knobs() {
        return std::tuple{Knob{"alpha", &Conduction::alpha, {0, 10}, "the viscosity's"},
                          Knob{"kappa", &Conduction::kappa, app::positive, "conductivity"}};
    }
};
struct Plain {};
/// Made of others, with a knob of its own.
struct Dissipation {
    Viscosity viscosity;
    Conduction conduction;
    Plain plain;
    double limit = 3;
    static constexpr auto knobs() {
        return std::tuple{Knob{"limit", &Dissipation::limit, app::any, "of both"}};
    }
    static auto parts(auto& self) { return std::tie(self.viscosity, self.conduction, self.plain); }
};

}  // namespace

TEST_CASE("an effect's knobs are its parameters, with the values that it has") {
    // Fails if the defaults are taken instead of the values, or if parts are not looked at.
    const auto one = parameters_of(Viscosity{.alpha = 1.5});
    REQUIRE(one.list().size() == 2);
    CHECK(one.list()[0].name == "alpha");
    CHECK(one.list()[0].value == 1.5);
    CHECK(one.list()[0].range.high == 10);
    CHECK(one.list()[1].meaning == "of the quadratic one");
    const auto none = parameters_of(Plain{});
    CHECK(none.list().empty());
    const auto all = parameters_of(Dissipation{});
    std::string names;
    for (const auto& parameter : all.list()) names += parameter.name + " ";
    CHECK(names == "limit alpha beta kappa ");
    CHECK(all.value("alpha") == 1);  // the first of a name counts
}

TEST_CASE("parameters turn the knobs, and a name that several parts have turns them all") {
    // Fails if only the first part is turned, or if what is not named changes.
    app::Parameters parameters = parameters_of(Dissipation{});
    parameters.set("alpha", 4);
    parameters.set("kappa", 0.25);
    const Dissipation turned = with_parameters(Dissipation{}, parameters);
    CHECK(turned.viscosity.alpha == 4);
    CHECK(turned.conduction.alpha == 4);
    CHECK(turned.conduction.kappa == 0.25);
    CHECK(turned.viscosity.beta == 2);
    CHECK(turned.limit == 3);
    app::Parameters few;
    few.add({"beta", 7, app::any, ""});
    CHECK(with_parameters(Dissipation{}, few).viscosity.beta == 7);
    CHECK(with_parameters(Dissipation{}, few).viscosity.alpha == 1);
    CHECK_THROWS_AS(parameters.set("kappa", 0), app::UsageError);
}
