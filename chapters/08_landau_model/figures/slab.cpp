#include <algorithm>
#include <cmath>

#include "chapters/08_landau_model/figures/slab_profiles.hpp"
#include "common/exact/landau.hpp"

namespace sph::landau {
namespace {

/// Where s* is wrong by most, over 1 + t, among particles that are not at the edge; and by how much.
struct Worst {
    double place = 0, error = 0;
};
Worst worst_inside(const SlabProfile& profile) {
    constexpr double edge = 0.95;
    Worst worst;
    for (std::size_t i = profile.x.size() / 2; i < profile.x.size(); ++i) {
        const double place = profile.x[i] / (1 + profile.time);
        const double error = std::abs(profile.s_star[i] / profile.exact_s_star[i] - 1);
        if (place < edge && error > worst.error) worst = {place, error};
    }
    return worst;
}

}  // namespace

void slab(report::Run& run) {
    const auto profiles = slab_profiles(run, "slab", {2, 4, 6, 8, 10});
    run.fill("answer-slab", report::number(profiles.back().l1_s_star, 2));
    double largest = 0;
    for (const SlabProfile& one : profiles) largest = std::max(largest, worst_inside(one).error);
    run.fill("slab-worst", report::percent(largest));
    const auto all = [&](auto&& holds) { return std::all_of(profiles.begin(), profiles.end(), holds); };
    run.claim("slab-error", [&] {
        return all([](const SlabProfile& one) {
            return one.l1_s_star < 4e-4 && std::abs(one.momentum) < 1e-13 &&
                   std::abs(one.energy_drift) < 1e-6;
        });
    });
    run.claim("slab-weak", [&] {
        return all([](const SlabProfile& one) {
            const Worst worst = worst_inside(one);
            const double weak = exact::LandauSlab{one.time}.matching() / (1 + one.time);
            return worst.error < 0.012 && std::abs(worst.place - weak) < 0.03;
        });
    });
}
}  // namespace sph::landau
