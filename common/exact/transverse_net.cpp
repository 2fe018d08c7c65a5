#include "common/exact/transverse_net.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace exact::transverse {
namespace {

// Labels of the lines, from 0 on: one that runs inwards begins at the edge with the rapidity ln(1 + D), one
// that runs outwards leaves the head at the age last/(1 + D), with D = nearest (e^label - 1) and the label
// counted backwards from the last. So they lie the closer, the closer they are to the edge at tau0, to the
// head, and to its end on the axis: there the flow has no derivatives.
constexpr double coarse = 0.1;           ///< between the labels, on level 0
constexpr double closest = 14;           ///< nearest is e^-14 if the head has met the axis, or soon will
constexpr double not_close = 7;          ///< and e^-7 long before
constexpr double largest_rapidity = 10;  ///< of the outermost line inwards: 4e-9 of the age from the vacuum

constexpr int most_secants = 30;
constexpr double found = 1e-13;

/// What all nodes of a net have in common.
class Lines {
  public:
    explicit Lines(const Net& net) : radius_{net.radius}, tau0_{net.tau0}, c2_{net.c2}, c_{std::sqrt(c2_)} {}

    Node start(double rapidity) const {
        return {0, 0, 0, -2 * c_ * rapidity, std::exp(2 * rapidity), std::expm1(2 * rapidity) / radius_};
    }
    Node head(double age) const { return {age, age * (1 + c_), 0, 0, 1, 0}; }
    Node meet(const Node& a, const Node& b, double guess) const;
    Node on_axis(const Node& b) const;
    double rapidity(const Node& n) const { return (n.psi - n.phi) / (2 * c_); }

  private:
    /// Along a line: one minus its speed, and what changes its psi or phi.
    struct Rate {
        double lag, change;
    };
    Rate outwards(const Node& n) const {
        const double d = 1 / ((1 + c_) * n.grown + 1 - c_);
        return {2 * (1 - c_) * d, c2_ * d * (c_ * (n.grown - 1) / (tau0_ + n.age) - n.slope)};
    }
    Rate inwards(const Node& n) const {
        const double d = 1 / ((1 - c_) * n.grown + 1 + c_);
        return {2 * (1 + c_) * d, -c2_ * d * (c_ * (n.grown - 1) / (tau0_ + n.age) + n.slope)};
    }

    double radius_, tau0_, c2_, c_;
};

/// Where the line outwards from `a` meets the line inwards from `b`, by the trapezoidal rule along both. All
/// follows from the rapidity there; the one that comes out is the one put in, found by secants.
Node Lines::meet(const Node& a, const Node& b, double guess) const {
    const Rate from_a = outwards(a), from_b = inwards(b);
    Node n{};
    const auto excess = [&](double xi) {
        n.grown = std::exp(2 * xi);
        n.age = a.age, n.slope = 0;
        const double out = (from_a.lag + outwards(n).lag) / 2, in = (from_b.lag + inwards(n).lag) / 2;
        const double step = (a.depth - b.depth + in * (b.age - a.age)) / (in - out);
        n.age = a.age + step;
        n.depth = a.depth + out * step;
        n.slope = (n.grown - 1) / (radius_ + n.age - n.depth);
        n.psi = a.psi + (from_a.change + outwards(n).change) / 2 * step;
        n.phi = b.phi + (from_b.change + inwards(n).change) / 2 * (n.age - b.age);
        return rapidity(n) - xi;
    };
    double xi = guess, off = excess(xi), next = xi + off;
    for (int k = 0; k < most_secants && std::fabs(next - xi) > found * (1 + std::fabs(xi)); ++k) {
        const double next_off = excess(next), rise = (next_off - off) / (next - xi);
        xi = std::exchange(next, next - next_off / rise);
        off = next_off;
    }
    return n;
}

/// Where the line inwards from `b` meets the axis: there xi = 0, so psi = phi. The slope is that of b, which
/// costs no order: each line meets the axis once. With a slope continued along the line, neighbours would
/// swing.
Node Lines::on_axis(const Node& b) const {
    Node n{0, 0, 0, 0, 1, b.slope};
    const double in = (inwards(b).lag + 1 + c_) / 2;
    n.age = (b.depth - in * b.age - radius_) / (1 - in);
    n.depth = radius_ + n.age;
    n.phi = n.psi = b.phi + (inwards(b).change + inwards(n).change) / 2 * (n.age - b.age);
    return n;
}

/// Rows of nodes that follow each other.
struct Rows {
    const Lines& lines;
    const Net::Late& late;
    std::vector<Node> last{}, row{};

    /// On from the first node of `row`, on the line inwards of that number. False if that node is late.
    bool extend(std::size_t first) {
        if (!(late(row[first]) <= 0)) return false;
        row.resize(first + 1);
        for (std::size_t i = first + 1; i < last.size() && late(row.back()) <= 0; ++i) {
            const double guess =
                lines.rapidity(row.back()) + lines.rapidity(last[i]) - lines.rapidity(last[i - 1]);
            row.push_back(lines.meet(row.back(), last[i], guess));
        }
        return true;
    }
    void next() { std::swap(last, row); }
};

/// Where the lines of a net begin.
class Labels {
  public:
    Labels(const Net& net, double age) : last_age_{std::fmin(age, net.radius / std::sqrt(net.c2))} {
        const double meeting = net.radius / std::sqrt(net.c2), c = std::sqrt(net.c2),
                     gain = (1 + c) / (1 - c), share = (1 - 1 / (gain * gain)) / 2;
        near_ = age >= meeting ? closest
                               : std::clamp(not_close - std::log(meeting / age - 1), not_close, closest);
        inwards = steps(largest_rapidity + near_);
        // On a line outwards in plane flow the age grows as e^(xi/share). The first one meets all lines
        // before `age`.
        outwards = steps(largest_rapidity / share - std::log(age / last_age_) + near_);
    }
    std::size_t inwards, outwards;  ///< the last lines, counted from 0 in spacings of level 0

    double rapidity(double line) const { return std::log1p(distance(line)); }
    double age(double line) const { return last_age_ / (1 + distance(static_cast<double>(outwards) - line)); }

  private:
    static std::size_t steps(double length) { return static_cast<std::size_t>(std::ceil(length / coarse)); }
    double distance(double line) const { return std::exp(-near_) * std::expm1(coarse * line); }

    double last_age_, near_;
};

}  // namespace

std::size_t Net::rows_from_head(double age) const {
    return Labels{*this, age}.outwards + 1;
}

void Net::walk(const Late& late, double age, const Use& use) const {
    const Lines lines{*this};
    const Labels labels{*this, age};
    const std::size_t ratio = std::size_t{1} << level, last = labels.outwards * ratio;
    const auto label = [&](std::size_t line) {
        return static_cast<double>(line) / static_cast<double>(ratio);
    };

    Rows rows{lines, late};
    for (std::size_t i = 0; i <= labels.inwards * ratio; ++i)
        rows.last.push_back(lines.start(labels.rapidity(label(i))));
    for (std::size_t j = 0; j <= last; ++j, rows.next()) {
        rows.row = {lines.head(labels.age(label(j)))};
        if (j == last && age >= radius / std::sqrt(c2))
            rows.row[0].slope = rows.last[1].slope;  // on the axis
        if (!rows.extend(0)) return;
        if (j % ratio == 0) use(j / ratio, rows.row);
    }
    for (std::size_t i = 1; i < rows.last.size() && age >= radius / std::sqrt(c2); ++i, rows.next()) {
        rows.row.resize(i + 1);
        rows.row[i] = lines.on_axis(rows.last[i]);
        if (!rows.extend(i)) return;
        if (i % ratio == 0) use((last + i) / ratio, std::span{rows.row}.subspan(i));
    }
}

}  // namespace exact::transverse
