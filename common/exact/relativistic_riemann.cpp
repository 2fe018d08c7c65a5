#include "common/exact/relativistic_riemann.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/exact/relativistic_riemann_side.hpp"
#include "common/exact/require.hpp"

namespace exact {
namespace {

using relativistic_waves::Real;
using relativistic_waves::Side;
constexpr const char* problem = "relativistic Riemann problem";
constexpr Real infinity = std::numeric_limits<Real>::infinity();
/// So far below every double that it stands for 0, so far above the least Real that squares keep digits.
constexpr Real least = 1e200L * std::numeric_limits<Real>::min();

/// ln(a/b), with the digits of a - b where a is near b; a >= 0, b > 0.
Real log_ratio(Real a, Real b) {
    return std::abs(a - b) < b / 2 ? std::log1p((a - b) / b) : std::log(a / b);
}

/// artanh v - artanh w, with the digits of v - w where both are near 1.
Real rapidity_between(Real v, Real w) {
    if (v < w) return -rapidity_between(w, v);
    return std::log1p(2 * (v - w) / ((1 - v) * (1 + w))) / 2;
}

/// The function of ln p that vanishes at p_star. Pressures are counted from `base`, an initial one where
/// there is one: z = ln(p/base) keeps the digits of a small jump there.
struct Balance {
    const Side& l;
    const Side& r;
    Real closing = 0;  ///< y_L - y_R
    Real base = 1;
    Real base_left = log_ratio(l.p, base), base_right = log_ratio(r.p, base);

    struct Value {
        Side::Behind left, right;
        Real f, rounding;  ///< f_L + f_R - closing, and about by how much that may be wrong
        Real slope() const { return left.slope + right.slope; }
    };
    Real pressure(Real z) const { return std::max(base * std::exp(z), least); }
    Value operator()(Real z) const {
        const Real p = pressure(z);
        const Side::Behind left = l.behind(z - base_left, p), right = r.behind(z - base_right, p);
        const Real size = std::abs(left.push) + std::abs(right.push) + std::abs(closing);
        return {left, right, left.push + right.push - closing,
                2 * std::numeric_limits<Real>::epsilon() * size};
    }
};

/// sinh x for x + y = sum and sinh y = q sinh x:  (1 + q^2 + 2 q cosh sum) sinh^2 x = sinh^2 sum.
Real sinh_of_part(Real sum, Real q) {
    return std::sinh(sum) / std::sqrt(1 + q * q + 2 * q * std::cosh(sum));
}

/// The root if both waves were rarefactions, in closed form: as z from the left pressure. Both sides hot.
Real two_rarefactions(const Side& l, const Side& r, Real closing) {
    const Real exponent = (l.gamma - 1) / l.gamma;
    const Real q = std::sqrt(r.w / l.w) * std::exp(exponent / 2 * log_ratio(l.p, r.p));
    const Real sinh_left = sinh_of_part(l.k / 2 * (l.expansion() + r.expansion() + closing), q);
    return 2 / exponent * std::log(sinh_left / std::sqrt(l.w));
}

/// About the pressure of two strong shocks: sinh^2 f_K = p/(gamma rho_K h_K) for the hottest gas behind them.
Real two_strong_shocks(const Side& l, const Side& r, Real closing) {
    const Real inertia_left = l.gamma * l.rho * (1 + l.w), inertia_right = r.gamma * r.rho * (1 + r.w);
    const Real sinh_left = sinh_of_part(closing, std::sqrt(inertia_left / inertia_right));
    return inertia_left * sinh_left * sinh_left;
}

/// Of two cold gases about the root, else one of the pressures, the one that is nearer to it: what is light
/// has a small jump beside a dense gas that expands by many powers of ten.
Real base_pressure(const Side& l, const Side& r, Real closing) {
    if (l.p == 0 && r.p == 0) return two_strong_shocks(l, r, closing);
    if (l.p == 0 || r.p == 0) return std::max(l.p, r.p);
    const Real at_left = Balance{l, r, closing, l.p}(0).f, at_right = Balance{l, r, closing, r.p}(0).f;
    return std::abs(at_left) < std::abs(at_right) ? l.p : r.p;
}

/// Where to look first, given where f changes its sign.
Real guess(const Balance& f, Real low, Real high) {
    if (high == infinity) return std::max(low, log_ratio(two_strong_shocks(f.l, f.r, f.closing), f.base));
    if (f.l.p == 0 || f.r.p == 0) return high;
    return std::clamp(f.base_left + two_rarefactions(f.l, f.r, f.closing), low, high);
}

/// The root z in (low, high), by Newton's method, and by halves where that leaves the bracket or is slow: in
/// cold gas f grows as exp(z/2) over many powers of ten, and Newton's steps would be 2.
Real root_between(const Balance& f, Real low, Real high, Real z) {
    Real last = high - low, before_last = last;
    for (int step = 0; step < 300; ++step) {
        const Balance::Value value = f(z);
        const Real newton = z - value.f / value.slope();
        if (std::abs(value.f) <= value.rounding) return std::isfinite(newton) ? newton : z;
        (value.f < 0 ? low : high) = z;
        const bool slow = 2 * std::abs(value.f) > before_last * value.slope();
        const Real next = slow || !(newton > low && newton < high) ? (low + high) / 2 : newton;
        before_last = last;
        last = std::abs(next - z);
        z = next;
    }
    return z;
}

/// The root z: first brackets it.
Real root(const Balance& f) {
    Real low = -infinity, high = infinity;
    for (const Real z : {f.base_left, f.base_right}) {
        if (!std::isfinite(z)) continue;
        const Real value = f(z).f;
        if (value == 0) return z;  // nothing happens on this side
        if (value < 0)
            low = std::max(low, z);
        else
            high = std::min(high, z);
    }
    const Real start = guess(f, low, high);
    for (Real step = 1; low == -infinity; step *= 4)
        if (f(start - step).f < 0 || step > 1e6L) low = start - step;
    for (Real step = 1; high == infinity; step *= 2)
        if (f(start + step).f > 0 || step > 1e3L) high = start + step;
    return root_between(f, low, high, start);
}

RelativisticRiemann::Speed speed(Real rapidity) {
    return {static_cast<double>(std::tanh(rapidity)), static_cast<double>(rapidity)};
}

Side side_of(const RelativisticRiemann::State& state, double gamma, bool left) {
    const Real rapidity = std::atanh(Real{state.v});
    return {state.rho, left ? rapidity : -rapidity, state.p, gamma};
}

RelativisticRiemann::Point point(Real rho, Real rapidity, Real p, Real u) {
    const auto [v, y] = speed(rapidity);
    return {static_cast<double>(rho), v, static_cast<double>(p), static_cast<double>(u), y};
}

struct Solution {
    RelativisticRiemann::Star star;
    RelativisticRiemann::Waves waves;
};

/// The gas expands freely; where a side is empty its wave shrinks to the other's front.
Solution with_vacuum(const Side& l, const Side& r) {
    const Real l_front = l.rapidity + l.expansion(), r_front = -(r.rapidity + r.expansion());
    const Real from = l.empty() ? r_front : l_front, to = r.empty() ? l_front : r_front;
    const Real l_head = l.empty() ? from : l.rapidity - l.sound(l.w);
    const Real r_head = r.empty() ? to : -(r.rapidity - r.sound(r.w));
    const auto [v, rapidity] = speed((from + to) / 2);
    return {{0, v, 0, 0, 0, 0, rapidity, true},
            {{speed(l_head), speed(from), false}, {v, rapidity}, {speed(r_head), speed(to), false}}};
}

/// Gas on both sides of the contact.
Solution with_contact(const Side& l, const Side& r, Real p, const Side::Behind& left,
                      const Side::Behind& right) {
    // From the side on which fewer digits cancel; from both where they are alike, as mirrored problems ask.
    const Real from_left = l.rapidity - left.push, from_right = right.push - r.rapidity;
    const Real left_size = std::abs(l.rapidity) + std::abs(left.push);
    const Real right_size = std::abs(r.rapidity) + std::abs(right.push);
    const Real rapidity = left_size < right_size   ? from_left
                          : right_size < left_size ? from_right
                                                   : (from_left + from_right) / 2;
    const auto number = [](Real value) { return static_cast<double>(value); };
    const RelativisticRiemann::Speed contact = speed(rapidity);
    return {{number(p), contact.v, number(left.rho), number(right.rho), number(left.w / l.gamma),
             number(right.w / r.gamma), contact.rapidity, false},
            {{speed(l.head(left)), speed(l.tail(left)), left.shock},
             contact,
             {speed(-r.head(right)), speed(-r.tail(right)), right.shock}}};
}

Solution solution(const Side& l, const Side& r, Real closing) {
    const Real fastest = l.expansion() + r.expansion();
    if (l.empty() || r.empty() || -closing > fastest || (-closing == fastest && fastest > 0))
        return with_vacuum(l, r);
    if (l.p == 0 && r.p == 0 && closing == 0)  // cold gas that touches
        return with_contact(l, r, 0, l.behind(0, 0), r.behind(0, 0));
    const Balance f{l, r, closing, base_pressure(l, r, closing)};
    const Real z = root(f);
    const Balance::Value at_root = f(z);
    return with_contact(l, r, f.pressure(z), at_root.left, at_root.right);
}

}  // namespace

RelativisticRiemann::RelativisticRiemann(const State& left, const State& right, double gamma)
    : left_{left}, right_{right}, gamma_{gamma} {
    require(gamma > 1 && gamma <= 2, problem, "gamma", gamma, "(1, 2]");
    for (const State& state : {left, right}) {
        require(state.rho == 0 || (state.rho >= least_density && state.rho <= largest_scale), problem, "rho",
                state.rho, "1e-100..1e100 and 0");
        require(std::fabs(state.v) < 1, problem, "v", state.v, "(-1, 1)");
        require(state.p >= 0 && state.p <= largest_scale, problem, "p", state.p, "0..1e100");
        require(state.rho > 0 || state.p == 0, problem, "p in a vacuum", state.p, "0");
    }
    require(left.rho > 0 || right.rho > 0, problem, "rho of both sides", 0, "rho > 0 on one side at least");
    const Solution found =
        solution(side_of(left, gamma, true), side_of(right, gamma, false), rapidity_between(left.v, right.v));
    star_ = found.star;
    waves_ = found.waves;
}

RelativisticRiemann::Point RelativisticRiemann::undisturbed(bool left) const {
    const State& state = left ? left_ : right_;
    const double u = state.rho > 0 ? state.p / ((gamma_ - 1) * state.rho) : 0;
    return {state.rho, state.v, state.p, u, std::atanh(state.v)};
}

/// At x/t = tanh(y).
RelativisticRiemann::Point RelativisticRiemann::at_rapidity(long double y) const {
    const bool left = y < star_.rapidity;
    const Wave& wave = left ? waves_.left : waves_.right;
    const auto before = [&](const Speed& edge) { return y < edge.rapidity; };
    if (before(wave.head) == left) return undisturbed(left);
    if (before(wave.tail) == left) {
        const Side side = side_of(left ? left_ : right_, gamma_, left);
        const Real head = side.rapidity - side.sound(side.w);
        const auto [rho, rapidity, p, w] = side.fan(std::max(Real{0}, (left ? y : -y) - head));
        return point(rho, left ? rapidity : -rapidity, p, w / gamma_);
    }
    if (star_.vacuum) return {0, 0, 0, 0, 0};
    return {left ? star_.rho_left : star_.rho_right, star_.v, star_.p, left ? star_.u_left : star_.u_right,
            star_.rapidity};
}

RelativisticRiemann::Point RelativisticRiemann::at(double xi) const {
    require(std::isfinite(xi), problem, "x/t", xi, "the finite numbers");
    if (std::fabs(xi) >= 1) return undisturbed(xi < 0);
    return at_rapidity(std::atanh(Real{xi}));
}

RelativisticRiemann::Point RelativisticRiemann::at(double x, double t) const {
    require(std::isfinite(x), problem, "x", x, "the finite numbers");
    require(t >= 0, problem, "time", t, "0 and above");
    if (std::fabs(x) >= t) return undisturbed(x < 0);
    return at_rapidity(std::atanh(Real{x} / Real{t}));
}

}  // namespace exact
