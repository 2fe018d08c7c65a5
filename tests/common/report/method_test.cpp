#include "common/report/method.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "tests/common/app/child.hpp"

namespace {

using Names = std::vector<std::string>;

/// What is built: the numbers that the method had.
struct Product {
    std::string name, kernel;
    double h_over_dx, alpha, size;
};
struct Setup {
    double size = 0;
};
using TestMethod = report::Method<Product, Setup>;
using TestMethods = report::Methods<TestMethod>;

TestMethod method(std::string name, const std::vector<app::Parameter>& knobs) {
    TestMethod one{
        .name = name, .label = "the " + name, .look = {.marker = plot::Marker::plus}, .kernel = "cubic"};
    one.h_over_dx = 1.2;
    for (const auto& knob : knobs) one.parameters.add(knob);
    one.build = [](const TestMethod& self, const Setup& setup) {
        const double alpha = self.parameters.has("alpha") ? self.parameters.value("alpha") : 0;
        return std::make_unique<Product>(Product{self.name, self.kernel, self.h_over_dx, alpha, setup.size});
    };
    return one;
}

const TestMethods& methods() {
    static const TestMethods all{
        "viscous",
        {method("plain", {}), method("viscous", {{"alpha", 1, {0, 10}, "strength"}}),
         method("heated", {{"alpha", 0.5, {0, 10}, "strength"}, {"kappa", 2, app::positive, ""}})}};
    return all;
}

/// The method that a reader's words choose, or the message that refuses them.
class Reader {
  public:
    explicit Reader(std::vector<std::string> kernels = {"cubic", "quintic"})
        : options_{methods(), std::move(kernels), {0.5, 8}} {
        options_.declare(line_);
    }
    TestMethod chosen(Names words) {
        const child::Arguments arguments{std::move(words)};
        static_cast<void>(line_.parse(arguments.count(), arguments.values()));
        return options_.chosen();
    }
    std::string refusal(Names words) {
        try {
            chosen(std::move(words));
        } catch (const app::UsageError& error) {
            return error.what();
        }
        return "accepted";
    }
    const app::CommandLine& line() const { return line_; }
    const report::MethodOptions<TestMethod>& options() const { return options_; }

  private:
    app::CommandLine line_{"program", "text"};
    report::MethodOptions<TestMethod> options_;
};

}  // namespace

TEST_CASE("methods are found by name, and one of them is recommended by name") {
    // Fails if the last one is the recommended one, or if a name may stand twice.
    CHECK(methods().size() == 3);
    CHECK(methods().names() == Names{"plain", "viscous", "heated"});
    CHECK(methods().recommended().name == "viscous");
    CHECK(methods()["heated"].label == "the heated");
    CHECK(methods().named({"heated", "plain"}).front().name == "heated");
    REQUIRE(methods().without({"viscous"}).size() == 2);
    CHECK(methods().without({"viscous"})[1].name == "heated");
    CHECK(methods().text() == "plain\nviscous (recommended)\nheated\n");
    CHECK(methods()["plain"].styled().label == "the plain");
    CHECK(methods()["plain"].styled().marker == plot::Marker::plus);
    CHECK_THROWS_WITH(methods()["heat"], "no such method: heat");
    CHECK_THROWS_WITH((TestMethods{"a", {method("a", {}), method("a", {})}}), "two methods are named a");
    CHECK_THROWS_WITH((TestMethods{"b", {method("a", {})}}), "no such method: b");
}

TEST_CASE("a method builds what a scene runs, with the values that it has now") {
    // Fails if the builder keeps the values of the method that it was made for.
    TestMethod changed = methods()["viscous"];
    changed.kernel = "quintic";
    changed.parameters.set("alpha", 3);
    const auto product = changed.make({.size = 7});
    CHECK(product->name == "viscous");
    CHECK(product->kernel == "quintic");
    CHECK(product->alpha == 3);
    CHECK(product->size == 7);
    CHECK(methods()["viscous"].make({})->alpha == 1);
}

TEST_CASE("a reader chooses a method and turns what may be turned at it") {
    // Fails if a default overrides the method's own value, or if a value reaches another method.
    CHECK(Reader{}.chosen({}).name == "viscous");
    CHECK(Reader{}.chosen({}).parameters.value("alpha") == 1);
    CHECK(Reader{}.chosen({"--method", "heated"}).parameters.value("alpha") == 0.5);
    const TestMethod turned = Reader{}.chosen(
        {"--method", "heated", "--kernel", "quintic", "--h-over-dx", "2", "--kappa", "3", "--alpha", "4"});
    CHECK(turned.kernel == "quintic");
    CHECK(turned.h_over_dx == 2);
    CHECK(turned.parameters.value("kappa") == 3);
    CHECK(turned.parameters.value("alpha") == 4);
    CHECK(methods()["heated"].parameters.value("alpha") == 0.5);
}

TEST_CASE("what the chosen method does not have is refused, naming who has it") {
    // Fails if the option is ignored: the figure would show what it was not asked for.
    CHECK(Reader{}.refusal({"--kappa", "1"}) ==
          "--kappa: the method viscous does not take it; allowed with heated");
    CHECK(Reader{}.refusal({"--method", "plain", "--alpha", "1"}) ==
          "--alpha: the method plain does not take it; allowed with viscous, heated");
    CHECK(Reader{}.refusal({"--method", "viscuos"}) ==
          "--method: viscuos is not allowed; allowed: list, plain, viscous, heated");
    CHECK(Reader{}.refusal({"--alpha", "11"}) == "--alpha: 11 is not allowed; allowed: 0..10");
    CHECK(Reader{}.refusal({"--kernel", "quartic"}).find("allowed: cubic, quintic") != std::string::npos);
}

TEST_CASE("options of methods in --help, and without a choice of kernels") {
    // Fails if a parameter of two methods is declared twice, or if its takers are not told.
    CHECK(Reader{}.line().names() == Names{"method", "kernel", "h-over-dx", "alpha", "kappa"});
    CHECK(Reader{}.line().entries().find("strength (viscous, heated); default: the method's") !=
          std::string::npos);
    CHECK(Reader{{}}.line().names() == Names{"method", "alpha", "kappa"});
    Reader reader;
    CHECK_FALSE(reader.options().wants_list());
    const child::Arguments words{{"--method", "list"}};
    app::CommandLine line{"program", "text"};
    report::MethodOptions<TestMethod> options{methods(), {}, app::any};
    options.declare(line);
    REQUIRE(line.parse(words.count(), words.values()));
    CHECK(options.wants_list());
}
