#include "chapters/09_transverse_expansion/scenes/flow.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "chapters/09_transverse_expansion/discs.hpp"
#include "common/exact/gubser.hpp"
#include "common/exact/transverse.hpp"

namespace sph::transverse {

Flow cylinder(double R, double tau0, double c2) {
    Flow flow{"cylinder", tau0, c2, R, R, true, {}, {}, {}};
    flow.spacing = [R](double r) { return graded_spacing(r, R); };
    flow.start = [](double) { return FlowState{1, 0}; };
    using Kept = std::map<double, std::shared_ptr<const exact::TransverseProfile>>;
    flow.exact = [kept = std::make_shared<Kept>(),
                  solution = exact::TransverseFlow{R, tau0, c2}](double tau) -> FlowProfile {
        auto& profile = (*kept)[tau];
        if (!profile) profile = std::make_shared<exact::TransverseProfile>(solution, tau);
        return [profile](double r) {
            const auto state = profile->at(r);
            return FlowState{state.temperature, std::sinh(state.rapidity)};
        };
    };
    return flow;
}

Flow gubser(double q, double tau0) {
    Flow flow{"gubser", tau0, 1.0 / 3, std::max(4.0, 4 / q), 2.5 / q, false, {}, {}, {}};
    flow.spacing = [q](double r) { return std::sqrt(1 + q * q * r * r); };
    flow.exact = [q](double tau) -> FlowProfile {
        return [q, tau](double r) {
            const auto state = exact::GubserFlow{q}.at(tau, r);
            return FlowState{state.temperature, state.u_r};
        };
    };
    flow.start = flow.exact(tau0);
    return flow;
}

}  // namespace sph::transverse
