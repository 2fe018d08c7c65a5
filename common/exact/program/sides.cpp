#include "common/exact/program/sides.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "common/app/error.hpp"

namespace exact::program {
namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& quantity, double value,
                         const std::string& allowed) {
    throw app::UsageError{
        fmt::format("{}: {} {} is not allowed; allowed: {}", option, quantity, value, allowed)};
}

}  // namespace

Sides::Sides(std::vector<double> left, std::vector<double> right, Limits limits)
    : left_{std::move(left)}, right_{std::move(right)}, limits_{limits} {}

void Sides::declare(app::CommandLine& command) {
    const app::Range scale{-limits_.largest, limits_.largest};
    command.numbers("left", left_, scale, "", "density, velocity and pressure at x < 0", 3);
    command.numbers("right", right_, scale, "", "density, velocity and pressure at x > 0", 3);
}

void Sides::check(const std::string& option, const std::vector<double>& values) const {
    const double rho = values[0], v = values[1], p = values[2];
    if (rho < 0 || (rho > 0 && rho < limits_.least_density)) {
        const bool any = limits_.least_density == 0;
        refuse(option, "density", rho,
               any ? "0 and above" : fmt::format("{} and above, and 0", limits_.least_density));
    }
    if (!limits_.velocity.contains(v)) refuse(option, "velocity", v, limits_.velocity.text());
    if (p < 0) refuse(option, "pressure", p, "0 and above");
    if (rho == 0 && p > 0) refuse(option, "pressure", p, "0 in a vacuum, where the density is 0");
}

void Sides::check() const {
    check("--left", left_);
    check("--right", right_);
    if (left_[0] == 0 && right_[0] == 0)
        refuse("--right", "density", 0, "above 0 where the left side is a vacuum");
}

void Sides::convert(const std::function<double(double)>& velocity) {
    for (auto* values : {&left_, &right_}) {
        const char* option = values == &left_ ? "--left" : "--right";
        try {
            (*values)[1] = velocity((*values)[1]);
        } catch (const std::domain_error& error) {
            throw app::UsageError{fmt::format("{}: {}", option, error.what())};
        }
    }
}

}  // namespace exact::program
