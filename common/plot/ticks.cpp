#include "common/plot/ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "common/plot/number_text.hpp"

namespace plot {
namespace {

/// A step of mantissa * 10^exponent, mantissa one of 1, 2, 2.5, 5, as whole numbers where it can be one: the
/// k-th multiple is then the double nearest to its decimal text.
struct Step {
    double mantissa = 1;
    int exponent = 0;

    double multiple(double k) const {
        const double scaled = k * mantissa;
        return exponent < 0 ? scaled / std::pow(10.0, -exponent) : scaled * std::pow(10.0, exponent);
    }
    int decimals() const { return std::max(0, (mantissa == 2.5 ? 1 : 0) - exponent); }
};

Step step_for(double span, int most) {
    const double least = span / std::max(most, 1) * (1 - 1e-6);
    Step step{1, static_cast<int>(std::floor(std::log10(least)))};
    for (const double mantissa : {1.0, 2.0, 2.5, 5.0}) {
        step.mantissa = mantissa;
        if (step.multiple(1) >= least) return step;
    }
    return {1, step.exponent + 1};
}

/// Whole multiples of the step inside the range; rounding errors at its ends do not lose a tick.
std::vector<double> multiples(const Range& range, const Step& step) {
    const double size = step.multiple(1);
    const double slack = 1e-6 + 4e-16 * std::max(std::abs(range.low), std::abs(range.high)) / size;
    std::vector<double> result;
    for (double k = std::ceil(range.low / size - slack); k <= std::floor(range.high / size + slack); k += 1)
        result.push_back(k);
    return result;
}

Values minor_multiples(const Range& range, const Step& step) {
    // Fifths of 1, 5 and 2.5 are round numbers again; of 2, quarters are.
    const int parts = step.mantissa == 2 ? 4 : 5;
    const double size = step.multiple(1) / parts;
    Values result;
    for (double k = std::ceil(range.low / size); k <= std::floor(range.high / size); k += 1)
        if (std::fmod(k, parts) != 0) result.push_back(k * size);
    return result;
}

int order_of(double value) {
    return value == 0 ? 0 : static_cast<int>(std::floor(std::log10(value) + 1e-9));
}

/// What the labels leave out: they show (value - offset) / 10^power.
struct Reduction {
    double offset = 0;
    int power = 0;
    int decimals = 0;

    std::string text() const {
        std::string result = power == 0 ? "" : "×" + power_of_ten(power);
        if (offset == 0) return result;
        if (!result.empty()) result += " ";
        return result + (offset < 0 ? "\u2212 " : "+ ") + short_number(std::abs(offset), 15);
    }
};

Reduction reduction_for(double low, double high, const Step& step) {
    Reduction result;
    double largest = std::max(std::abs(low), std::abs(high));
    constexpr int most_digits = 5;
    if (order_of(largest) + 1 + step.decimals() > most_digits &&
        order_of(largest) - step.exponent >= most_digits) {
        const double unit = std::pow(10.0, std::ceil(std::log10(high - low) - 1e-9));
        result.offset = std::trunc(low / unit + std::copysign(1e-9, low)) * unit;
        largest = std::max(std::abs(low - result.offset), std::abs(high - result.offset));
    }
    const int order = order_of(largest);
    const bool large = order >= 5;
    const bool small = order <= -4 || (order == -3 && step.decimals() > 3);
    if (large || small) result.power = order;
    result.decimals = std::max(0, result.power - step.exponent + (step.mantissa == 2.5 ? 1 : 0));
    return result;
}

/// Numbers such as 20 or 0.05 where all are short, otherwise 2×10^{−5}.
std::string log_label(double value, bool plain) {
    if (plain) return short_number(value, 6);
    const int exponent = order_of(value);
    const double mantissa = value / std::pow(10.0, exponent);
    if (std::abs(mantissa - 1) < 1e-9) return power_of_ten(exponent);
    return short_number(mantissa, 6) + "×" + power_of_ten(exponent);
}

bool all_short(const std::vector<Tick>& ticks) {
    return std::all_of(ticks.begin(), ticks.end(),
                       [](const Tick& tick) { return tick.value > 0.0099 && tick.value < 99999; });
}

/// mantissa * 10^n for all n that lie in the range.
Values decade_multiples(const Range& range, std::span<const double> mantissas) {
    Values result;
    const int last = order_of(range.high);
    for (int n = order_of(range.low) - 1; n <= last; ++n)
        for (const double mantissa : mantissas) {
            const double value = n < 0 ? mantissa / std::pow(10.0, -n) : mantissa * std::pow(10.0, n);
            if (value >= range.low * (1 - 1e-9) && value <= range.high * (1 + 1e-9)) result.push_back(value);
        }
    return result;
}

constexpr std::array<double, 9> all_mantissas{1, 2, 3, 4, 5, 6, 7, 8, 9};

/// Every 7th or 8th decade would be hard to count.
int round_stride(int least) {
    for (const int stride : {1, 2, 3, 4, 5, 6, 10, 15, 20, 25, 30, 40, 50, 100, 150, 200})
        if (stride >= least) return stride;
    return least;
}

Ticks decade_ticks(const Range& range, const Values& powers, int most) {
    Ticks ticks;
    const int intervals = static_cast<int>(powers.size()) - 1;
    const int stride = round_stride((intervals + most - 1) / std::max(most, 1));
    for (const double power : powers) {
        const int exponent = order_of(power);
        if (stride <= 1 || exponent % stride == 0)
            ticks.major.push_back({power, power_of_ten(exponent)});
        else
            ticks.minor.push_back(power);
    }
    if (stride > 1) return ticks;
    for (const double value : decade_multiples(range, std::span{all_mantissas}.subspan(1)))
        ticks.minor.push_back(value);
    return ticks;
}

/// Fewer than two powers of ten: the finest of some sets of round numbers with at most `most` intervals.
Ticks part_of_decade_ticks(const Range& range, int most) {
    constexpr std::array<double, 3> one_two_five{1, 2, 5};
    constexpr std::array<double, 2> one_three{1, 3};
    const std::array<std::span<const double>, 3> sets{all_mantissas, one_two_five, one_three};
    Ticks ticks;
    for (const auto& mantissas : sets) {
        const Values values = decade_multiples(range, mantissas);
        // all nine would crowd at the end of a decade: only for a range that holds few of them
        const std::size_t limit = static_cast<std::size_t>(mantissas.size() == 9 ? std::min(most, 5) : most);
        if (values.size() < 3 || values.size() > limit + 1) continue;
        for (const double value : values) ticks.major.push_back({value, ""});
        break;
    }
    if (ticks.major.empty()) {
        ticks = linear_ticks(range, most);
        std::erase_if(ticks.major, [](const Tick& tick) { return tick.value <= 0; });
        ticks.minor.clear();
        return ticks;
    }
    const bool plain = all_short(ticks.major);
    for (auto& tick : ticks.major) tick.label = log_label(tick.value, plain);
    for (const double value : decade_multiples(range, all_mantissas))
        if (std::none_of(ticks.major.begin(), ticks.major.end(),
                         [value](const Tick& tick) { return tick.value == value; }))
            ticks.minor.push_back(value);
    return ticks;
}

}  // namespace

Ticks linear_ticks(const Range& range, int most) {
    const Step step = step_for(range.span(), most);
    const auto counts = multiples(range, step);
    Ticks ticks;
    if (counts.empty()) return ticks;
    const Reduction reduction =
        reduction_for(step.multiple(counts.front()), step.multiple(counts.back()), step);
    const double scale = std::pow(10.0, reduction.power);
    for (const double k : counts) {
        const double value = step.multiple(k);
        ticks.major.push_back({value, number_text((value - reduction.offset) / scale, reduction.decimals)});
    }
    ticks.factor = reduction.text();
    ticks.minor = minor_multiples(range, step);
    return ticks;
}

Ticks log_ticks(const Range& range, int most) {
    constexpr std::array<double, 1> one{1};
    const Values powers = decade_multiples(range, one);
    return powers.size() >= 2 ? decade_ticks(range, powers, most) : part_of_decade_ticks(range, most);
}

Ticks given_ticks(const Axis& axis, const Range& range) {
    Ticks ticks;
    const double slack = 1e-9 * range.span();
    for (std::size_t k = 0; k < axis.ticks.size(); ++k) {
        const double value = axis.ticks[k];
        if (value < range.low - slack || value > range.high + slack) continue;
        ticks.major.push_back({value, k < axis.tick_names.size() ? axis.tick_names[k] : ""});
    }
    std::stable_sort(ticks.major.begin(), ticks.major.end(),
                     [](const Tick& a, const Tick& b) { return a.value < b.value; });
    if (!axis.tick_names.empty()) return ticks;
    if (axis.scale == Scale::log) {
        const bool powers = std::all_of(ticks.major.begin(), ticks.major.end(), [](const Tick& tick) {
            return std::abs(std::log10(tick.value) - std::round(std::log10(tick.value))) < 1e-9;
        });
        const bool plain = !powers && all_short(ticks.major);
        for (auto& tick : ticks.major) tick.label = log_label(tick.value, plain);
        return ticks;
    }
    int decimals = 0;
    const auto exact = [&](const Tick& tick) {
        return std::abs(std::round(tick.value * std::pow(10.0, decimals)) / std::pow(10.0, decimals) -
                        tick.value) <= 1e-4 * range.span();
    };
    while (decimals < 12 && !std::all_of(ticks.major.begin(), ticks.major.end(), exact)) ++decimals;
    for (auto& tick : ticks.major) tick.label = number_text(tick.value, decimals);
    return ticks;
}

}  // namespace plot
