#include "common/plot/ticks.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "common/plot/number_text.hpp"
#include "plain_measure.hpp"

using namespace plot;

namespace {

std::string labels(const Ticks& ticks) {
    std::string joined;
    for (const auto& tick : ticks.major) joined += (joined.empty() ? "" : " ") + tick.label;
    return joined;
}

Values values(const Ticks& ticks) {
    Values result;
    for (const auto& tick : ticks.major) result.push_back(tick.value);
    return result;
}

/// Smallest gap between neighbouring labels; negative if two overlap.
double smallest_gap(const Ticks& ticks, const AxisMap& map, double size) {
    double gap = 1e9, end = -1e9;
    for (const auto& tick : ticks.major) {
        if (tick.label.empty()) continue;
        const double half = plain_measure(tick.label, size).width / 2, at = map(tick.value);
        if (end > -1e8) gap = std::min(gap, at - half - end);
        end = at + half;
    }
    return gap;
}

}  // namespace

TEST_CASE("linear ticks are round numbers with equal decimals") {
    struct Case {
        Range range;
        int most;
        const char* labels;
        const char* factor;
    };
    // Fails if 2.5 is missing from the steps, if decimals follow each number alone ("0 0.25 0.5"), or if the
    // hyphen is kept for the minus sign.
    const auto [range, most, expected, factor] = GENERATE(values<Case>({
        {{0, 1}, 5, "0.0 0.2 0.4 0.6 0.8 1.0", ""},
        {{0, 1}, 4, "0.00 0.25 0.50 0.75 1.00", ""},
        {{-0.5, 0.5}, 5, "−0.4 −0.2 0.0 0.2 0.4", ""},
        {{0, 100}, 6, "0 20 40 60 80 100", ""},
        {{0, 30000}, 3, "0 10000 20000 30000", ""},
        {{0, 1e-3}, 5, "0.0 0.2 0.4 0.6 0.8 1.0", "×10^{−3}"},
        {{0, 2e-7}, 4, "0.0 0.5 1.0 1.5 2.0", "×10^{−7}"},
        {{0, 4e9}, 4, "0 1 2 3 4", "×10^{9}"},
        {{1e6, 1e6 + 1e-3}, 5, "0.0 0.2 0.4 0.6 0.8 1.0", "×10^{−3} + 1000000"},
        {{-2.000003, -2.0000005}, 5, "−3.0 −2.5 −2.0 −1.5 −1.0 −0.5", "×10^{−6} − 2"},
        {{0.9996, 1.0004}, 4, "0.9996 0.9998 1.0000 1.0002 1.0004", ""},
    }));
    const Ticks ticks = linear_ticks(range, most);
    CHECK(labels(ticks) == expected);
    CHECK(ticks.factor == factor);
}

TEST_CASE("multiples of a tenth are the doubles nearest to their text") {
    // Fails if ticks are summed up, 0.1 + 0.1 + 0.1 = 0.30000000000000004.
    CHECK(values(linear_ticks({0, 0.5}, 5)) == Values{0, 0.1, 0.2, 0.3, 0.4, 0.5});
}

TEST_CASE("log ticks are powers of ten, thinned, or parts of a decade") {
    struct Case {
        Range range;
        int most;
        const char* labels;
    };
    // Fails if the last power is lost to rounding (1e3), if every 7th power is shown, or without 2 and 5.
    const auto [range, most, expected] = GENERATE(values<Case>({
        {{1e-3, 1e3}, 8, "10^{−3} 10^{−2} 10^{−1} 10^{0} 10^{1} 10^{2} 10^{3}"},
        {{1e-30, 1e5}, 5, "10^{−30} 10^{−20} 10^{−10} 10^{0}"},
        {{40, 7000}, 5, "10^{2} 10^{3}"},
        {{15, 600}, 6, "20 50 100 200 500"},
        {{1.5e-6, 7e-5}, 6, "2×10^{−6} 5×10^{−6} 10^{−5} 2×10^{−5} 5×10^{−5}"},
        {{200, 400}, 5, "200 300 400"},
        {{110, 115}, 5, "110 111 112 113 114 115"},
    }));
    CHECK(labels(log_ticks(range, most)) == expected);
}

TEST_CASE("minor ticks of a decade are its multiples 2 to 9") {
    // Fails if the mantissa 1 is drawn twice or minor ticks leave the range.
    const Ticks ticks = log_ticks({1, 100}, 5);
    CHECK(ticks.minor.size() == 16);
    for (const double value : ticks.minor) CHECK(Range{1, 100}.contains(value));
}

TEST_CASE("ticks of random ranges are sorted, inside, three to ten, and their labels do not touch") {
    // On a narrow panel, long labels leave room for two. Fails if fitting_ticks returns its first attempt, or
    // if multiples() loses the slack at an end.
    std::mt19937 random{7};
    std::uniform_real_distribution<double> unit{0, 1};
    for (int k = 0; k < 3000; ++k) {
        const double span = std::pow(10.0, 24 * unit(random) - 12);
        const double low = (unit(random) - 0.5) * span * std::pow(10.0, 7 * unit(random));
        const AxisMap map{{low, low + span}, Scale::linear, 0, 300 + 700 * unit(random)};
        const Ticks ticks = fitting_ticks({}, map, Direction::horizontal, 18, plain_measure);
        CAPTURE(low, span, map.to, labels(ticks));
        REQUIRE(ticks.major.size() >= (map.to > 550 ? 3 : 2));
        REQUIRE(ticks.major.size() <= 10);
        for (std::size_t i = 0; i < ticks.major.size(); ++i) {
            REQUIRE(ticks.major[i].value >= low - 1e-6 * span);
            REQUIRE(ticks.major[i].value <= low + (1 + 1e-6) * span);
            if (i > 0) REQUIRE(ticks.major[i].value > ticks.major[i - 1].value);
            if (i > 0) REQUIRE(ticks.major[i].label != ticks.major[i - 1].label);
        }
        REQUIRE(smallest_gap(ticks, map, 18) > 0);
    }
}

TEST_CASE("log ticks of random ranges have at least two labels that do not touch") {
    // Fails if part_of_decade_ticks has no linear fallback (ranges such as 3.1..3.9).
    std::mt19937 random{8};
    std::uniform_real_distribution<double> unit{0, 1};
    Axis axis;
    axis.scale = Scale::log;
    for (int k = 0; k < 3000; ++k) {
        const double low = std::pow(10.0, 40 * unit(random) - 20);
        const double high = low * std::pow(10.0, 0.01 + 30 * std::pow(unit(random), 4));
        const AxisMap map{{low, high}, Scale::log, 0, 300 + 700 * unit(random)};
        const Ticks ticks = fitting_ticks(axis, map, Direction::horizontal, 18, plain_measure);
        CAPTURE(low, high, map.to, labels(ticks));
        REQUIRE(ticks.major.size() >= 2);
        for (const auto& tick : ticks.major) {
            REQUIRE(tick.value >= low * (1 - 1e-6));
            REQUIRE(tick.value <= high * (1 + 1e-6));
        }
        REQUIRE(smallest_gap(ticks, map, 18) > 0);
    }
}

TEST_CASE("given ticks keep their values; crowded labels are thinned, marks are not") {
    Axis axis;
    axis.scale = Scale::log;
    axis.ticks = {800, 100, 200, 400, 5000};
    // Fails if ticks outside the range are kept or the order is not restored.
    CHECK(labels(given_ticks(axis, {50, 1000})) == "100 200 400 800");
    axis.ticks = {1, 10, 100};
    CHECK(labels(given_ticks(axis, {1, 100})) == "10^{0} 10^{1} 10^{2}");

    Axis linear;
    linear.ticks = {0, 0.25, 1};
    CHECK(labels(given_ticks(linear, {0, 1})) == "0.00 0.25 1.00");
    linear.tick_names = {"none", "quarter", "all"};
    CHECK(labels(given_ticks(linear, {0, 1})) == "none quarter all");

    Axis crowded;
    for (int k = 0; k <= 50; ++k) crowded.ticks.push_back(k);
    const AxisMap map{{0, 50}, Scale::linear, 0, 400};
    // Fails if thin_labels removes the ticks with their labels, or stops at the first stride.
    const Ticks ticks = fitting_ticks(crowded, map, Direction::horizontal, 18, plain_measure);
    CHECK(ticks.major.size() == 51);
    CHECK(smallest_gap(ticks, map, 18) > 0);
}

TEST_CASE("numbers have a true minus sign and no negative zero") {
    CHECK(number_text(-0.25, 1) == "−0.2");  // round half to even
    CHECK(number_text(-1e-9, 2) == "0.00");
    CHECK(short_number(2.5e13) == "2.5×10^{13}");
    CHECK(short_number(-1e-7) == "−10^{−7}");
}
