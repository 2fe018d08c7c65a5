// The boost-invariant cylinder, by characteristics: against other solutions, and its laws.
#include "common/exact/transverse.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "common/exact/transverse_finite_volume.hpp"

using exact::TransverseFlow;
using exact::TransverseProfile;

namespace {

struct KnownPlace {
    double tau, r, temperature, rapidity;
};

/// Integral of s_star r dr from 0 to the edge, by Simpson's rule in two parts, which end where the flow has
/// no derivatives; their nodes lie close to their ends.
double entropy_of(const TransverseFlow& flow, const TransverseProfile& profile, double between) {
    const auto part = [&](double a, double b) {
        constexpr int n = 4000;
        double sum = 0;
        for (int k = 0; k <= n; ++k) {
            const double u = static_cast<double>(k) / n,
                         r = a + (b - a) * u * u * u * (10 + u * (6 * u - 15));
            const double slope = (b - a) * 30 * u * u * (1 - u) * (1 - u);
            sum += (k == 0 || k == n ? 1 : k % 2 == 1 ? 4 : 2) * profile.at(r).s_star * r * slope;
        }
        return sum / (3 * n);
    };
    return part(0, between) + part(between, flow.edge(profile.tau()));
}

}  // namespace

// Values of a spectral solution, to their 10 digits. Measured: 5.3e-8 of T, 6.8e-7 of the rapidity. Fails for
// any wrong sign in Rate, and for d phi/d r in eq. 297 as printed (the line outwards would carry phi).
TEST_CASE("transverse expansion: the values of another solution") {
    constexpr KnownPlace places[] = {
        {2, 9.45, 0.774317947343, 0.0428755451965},  {2, 10, 0.528562933551, 0.720352399071},
        {2, 10.999, 0.0578212326984, 4.64819986979}, {5, 7.7, 0.583407841509, 0.00413855516513},
        {5, 9, 0.442136054855, 0.485676434335},      {5, 13.95, 0.0806144832676, 3.63986947788},
        {10, 5, 0.452520241309, 0.0436843068454},    {10, 7.4, 0.346125667428, 0.487349652467},
        {10, 10.1, 0.270005791776, 0.902927713093},  {10, 14, 0.191388461144, 1.52497046086},
        {10, 18.5, 0.0876546698639, 3.07041524809},  {10, 18.99, 0.0284628730086, 5.0847437333},
    };
    double off = 0, rapidity_off = 0;
    for (const auto& place : places) {
        const auto state = TransverseProfile{{10, 1, 1.0 / 3}, place.tau}.at(place.r);
        off = std::max(off, std::fabs(state.temperature - place.temperature));
        rapidity_off = std::max(rapidity_off, std::fabs(state.rapidity - place.rapidity));
    }
    CHECK(off < 2e-7);
    CHECK(rapidity_off < 3e-6);
}

// Lengths in another unit. Measured: 2e-13. Fails if a length of the net does not scale.
TEST_CASE("transverse expansion: no length but R and tau0") {
    const TransverseProfile one{{5, 0.5, 0.2}, 4}, other{{500, 50, 0.2}, 400};
    for (const double r : {1.0, 4.0, 5.0, 7.0, 8.4})
        CHECK(other.at(100 * r).temperature == Approx(one.at(r).temperature).epsilon(1e-11));
}

// The integral is R^2 tau0/2. Measured: relative 1.0e-8, 1e-7, 2e-6 and 3e-7. Fails by more than 1e-2 for any
// wrong term in Rate, and by 1e-5 after the axis with slopes of lines continued there.
TEST_CASE("transverse expansion: its entropy stays, before the axis is reached and after") {
    struct Case {
        TransverseFlow flow;
        double tau, between, bound;
    };
    const Case cases[] = {{{10, 1, 1.0 / 3}, 8, -1, 1e-6},
                          {{2, 0.1, 0.15}, 3, -1, 1e-6},
                          {{10, 1, 1.0 / 3}, 20, 1.12729, 1e-5},
                          {{3, 2, 0.25}, 12, 1.0, 1e-4}};
    for (const auto& [flow, tau, between, bound] : cases) {
        const TransverseProfile profile{flow, tau};
        const double split = between < 0 ? flow.head(tau) : between;
        const double whole = flow.radius * flow.radius * flow.tau0 / 2;
        CAPTURE(tau, entropy_of(flow, profile, split) / whole - 1);
        CHECK(entropy_of(flow, profile, split) == Approx(whole).epsilon(bound));
    }
}

// Entropy and energy, by differences of profiles: d(tau r s u^tau)/d tau + d(tau r s u^r)/dr = 0 and
// d(tau r T00)/d tau + d(tau r T01)/dr = -r p. Measured: 2e-7 of the terms. Fails for any wrong term in Rate.
TEST_CASE("transverse expansion: conserves entropy and energy on both sides of what the axis sent out") {
    const TransverseFlow flow;
    constexpr double d = 0.02;
    const double tau = 22;
    const TransverseProfile before{flow, tau - d}, now{flow, tau}, after{flow, tau + d};
    const auto densities = [&](const TransverseProfile& profile, double r) {
        const auto state = profile.at(r);
        const double eps = std::pow(state.temperature, 4), cosh = std::cosh(state.rapidity);
        const double v = std::tanh(state.rapidity), weight = r * profile.tau();
        struct {
            double s, s_flux, e, e_flux, p;
        } all{state.s_star * r, state.s_star * r * v, weight * eps * (4 * cosh * cosh - 1) / 3,
              weight * eps * 4 * cosh * cosh * v / 3, r * eps / 3};
        return all;
    };
    for (const double r : {0.5, 1.5, 4.0, 8.0, 12.0, 20.0}) {
        const auto early = densities(before, r), late = densities(after, r), at = densities(now, r);
        const auto west = densities(now, r - d), east = densities(now, r + d);
        const double ds = late.s - early.s, flux = east.s_flux - west.s_flux;
        const double de = late.e - early.e, e_flux = east.e_flux - west.e_flux, work = 2 * d * at.p;
        CAPTURE(r, (ds + flux) / std::fabs(ds), (de + e_flux + work) / std::fabs(de));
        CHECK(std::fabs(ds + flux) < 2e-3 * (std::fabs(ds) + std::fabs(flux)));
        CHECK(std::fabs(de + e_flux + work) < 2e-3 * (std::fabs(de) + std::fabs(e_flux)));
    }
}

// As eq. 277 has it but for tau - tau0: the fluid at rest ends there. Fails for the printed tau.
TEST_CASE("transverse expansion: the head starts at tau0") {
    const TransverseFlow flow{10, 2, 1.0 / 3};
    const TransverseProfile profile{flow, 6};
    const double head = 10 - 4 / std::sqrt(3.0), printed = 10 - 6 / std::sqrt(3.0);
    CHECK(profile.at(head - 1e-9).rapidity == 0);
    CHECK(profile.at(head - 1e-9).temperature == Approx(std::pow(2.0 / 6, 1.0 / 3)).epsilon(1e-14));
    CHECK(profile.at(head + 0.05).rapidity > 0.01);
    CHECK(profile.at(printed + 0.05).rapidity == 0);
    CHECK(profile.at(14).temperature == 0);
    CHECK(profile.at(14 - 1e-12).temperature < 1e-3);
    CHECK(TransverseProfile{flow, 2}.at(10).temperature == 1);
    CHECK(TransverseProfile{flow, 2}.at(10.0001).temperature == 0);
}

// All events have that temperature, by profiles. Measured: 8e-7, and the end on the axis 3e-6.
TEST_CASE("transverse expansion: the freeze-out surface") {
    const TransverseFlow flow;
    const auto early = freeze_out_surface(flow, 0.5), late = freeze_out_surface(flow, 0.3);
    CHECK(early.front().r == 10);
    CHECK(early.back().tau == Approx(8).epsilon(1e-14));  // of Bjorken's flow
    CHECK(early.back().r == 0);
    CHECK(early[early.size() - 2].r == Approx(flow.head(8)).epsilon(1e-14));
    CHECK(late.back().tau < late[late.size() - 40].tau);  // the axis is coolest
    for (const auto* surface : {&early, &late}) {
        const double temperature = surface == &early ? 0.5 : 0.3;
        double most = 0;
        for (const auto& event : *surface) most = std::max(most, event.r);
        CHECK(most > 10);
        for (std::size_t k = 20; k + 2 < surface->size(); k += surface->size() / 5) {
            const auto& [tau, r] = (*surface)[k];
            CAPTURE(tau, r);
            CHECK(TransverseProfile{flow, tau}.at(r).temperature == Approx(temperature).margin(1e-5));
        }
    }
    CHECK(TransverseProfile{flow, late.back().tau}.at(0).temperature == Approx(0.3).margin(5e-5));
}

// By another method: rings converge to it with the first order that a kink and a vacuum allow.
// Measured: 9.8e-4, 4.8e-4 at tau = 10; 8.7e-4, 4.5e-4 at tau = 20.
TEST_CASE("transverse expansion: rings converge to it") {
    const TransverseFlow flow;
    const auto error = [&](double tau, std::size_t n) {
        const double end = flow.radius * static_cast<double>(n) / static_cast<double>(n - 4);
        exact::TransverseFiniteVolume rings{exact::disc(flow.radius, end, n), {}, {1, 0.5, 1 / end}};
        rings.advance_to(tau);
        const TransverseProfile profile{flow, tau};
        const auto cells = rings.cells();
        double off = 0, all = 0;
        for (std::size_t i = 0; i < n && cells.centre(i) < flow.radius; ++i) {
            const double r = cells.centre(i), exact_t = profile.at(r).temperature;
            off += r * std::fabs(std::pow(cells.states[i].eps, 0.25) - exact_t);
            all += r * exact_t;
        }
        return off / all;
    };
    for (const double tau : {10.0, 20.0}) {
        const double coarse = error(tau, 200), fine = error(tau, 400);
        CAPTURE(tau, coarse, fine);
        CHECK(fine < 6e-4);
        CHECK(coarse / fine == Approx(2).epsilon(0.15));
    }
}

TEST_CASE("transverse expansion: what is out of range is named") {
    CHECK_THROWS_AS((TransverseProfile{{10, 1, 0.6}, 2}), std::domain_error);
    CHECK_THROWS_AS((TransverseProfile{{10, 1, 1.0 / 3}, 0.9}), std::domain_error);
    CHECK_THROWS_AS((TransverseProfile{{10, 1, 1.0 / 3}, 100}), std::domain_error);
    CHECK_THROWS_AS((TransverseProfile{{10, 1e6, 1.0 / 3}, 1e6}), std::domain_error);
    CHECK_THROWS_AS((TransverseProfile{{10, 1, 1.0 / 3}, 2}.at(-1)), std::domain_error);
    CHECK_THROWS_AS(exact::freeze_out_surface({}, 1), std::domain_error);
    CHECK_THROWS_AS(exact::freeze_out_surface({}, 0.01), std::domain_error);
    CHECK_THROWS_AS(exact::disc(2, 1, 10), std::domain_error);
    CHECK_THROWS_AS((exact::TransverseFiniteVolume{exact::disc(1, 2, 10), {}, {0}}), std::domain_error);
}
