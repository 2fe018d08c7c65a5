#include "common/app/parameters.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "common/app/error.hpp"

TEST_CASE("parameters: each name once, the first one counts") {
    // Fails if a part that shares a parameter with an earlier one sets another value.
    app::Parameters parameters;
    parameters.add({"alpha", 1, {0, 10}, "strength"});
    parameters.add({"beta", 2, app::positive, ""});
    parameters.add({"alpha", 5, {0, 100}, "of another part"});
    REQUIRE(parameters.list().size() == 2);
    CHECK(parameters.list()[0].name == "alpha");
    CHECK(parameters.list()[0].meaning == "strength");
    CHECK(parameters.value("alpha") == 1);
    CHECK(parameters.has("beta"));
    CHECK_FALSE(parameters.has("gamma"));
    CHECK_THROWS_WITH(parameters.value("gamma"), "no parameter gamma");
}

TEST_CASE("a parameter takes what its range allows") {
    // Fails if the range is that of another parameter, or if a refused value is kept.
    app::Parameters parameters;
    parameters.add({"alpha", 1, {0, 10}, ""});
    parameters.add({"beta", 2, app::positive, ""});
    parameters.set("alpha", 0);
    CHECK(parameters.value("alpha") == 0);
    CHECK_THROWS_WITH(parameters.set("alpha", 10.5), "--alpha: 10.5 is not allowed; allowed: 0..10");
    CHECK_THROWS_AS(parameters.set("beta", 0), app::UsageError);
    CHECK(parameters.value("alpha") == 0);
    CHECK(parameters.value("beta") == 2);
    CHECK_THROWS_AS(parameters.set("gamma", 1), std::out_of_range);
}
