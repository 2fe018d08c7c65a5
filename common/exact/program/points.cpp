#include "common/exact/program/points.hpp"

#include <cmath>
#include <utility>

#include "common/app/error.hpp"
#include "common/app/option_text.hpp"

namespace exact::program {

Points::Points(std::string name, app::Range range, std::vector<double> window)
    : name_{std::move(name)}, range_{range}, window_{std::move(window)} {}

void Points::declare(app::CommandLine& command, const std::string& meaning) {
    command.numbers(name_, list_, range_, "", meaning + ", a comma-separated list");
    command.integer("points", count_, 2, 1'000'000,
                    "instead of --" + name_ + ": number of equidistant points");
    command.numbers("window", window_, range_, "", "first and last of the --points, increasing", 2);
}

std::vector<double> Points::values(const app::CommandLine& command) const {
    const bool listed = command.given(name_);
    const bool counted = command.given("points");
    const std::string list_option = "--" + name_;
    if (listed && counted) throw app::UsageError{list_option + " and --points: give one of them, not both"};
    if (command.given("window") && !counted) throw app::UsageError{"--window: goes with --points N"};
    if (listed) return list_;
    if (!counted)
        throw app::UsageError{list_option + ": missing; give it a list, or --points N --window a,b"};
    if (!(window_[0] < window_[1]))
        throw app::UsageError{"--window: " + app::option_text::shown(window_) +
                              " is not allowed; allowed: a,b with a < b"};
    std::vector<double> points;
    for (long k = 0; k < count_; ++k) {
        const double part = static_cast<double>(k) / static_cast<double>(count_ - 1);
        points.push_back(std::lerp(window_[0], window_[1], part));  // no overflow; both ends exactly
    }
    return points;
}

}  // namespace exact::program
