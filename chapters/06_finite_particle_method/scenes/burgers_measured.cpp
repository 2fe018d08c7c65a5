#include <cmath>

#include "chapters/06_finite_particle_method/scenes/burgers.hpp"

namespace sph::fpm {

report::Quantities BurgersRun::measured() const {
    report::Quantities all{{"l1_u", errors.back().l1},
                           {"linf_u", errors.back().linf},
                           {"worst_linf_u", worst_linf},
                           {"steps", static_cast<double>(steps)},
                           {"evaluations", static_cast<double>(evaluations)},
                           {"crossed", static_cast<double>(crossed)}};
    if (std::isfinite(relative)) all.push_back({"relative_u", relative});
    if (first_crossing >= 0) all.push_back({"first_crossing", first_crossing, "time"});
    if (remeshings > 0) {
        all.push_back({"remeshings", static_cast<double>(remeshings)});
        all.push_back({"mass_change", mass_change});
        all.push_back({"momentum_change", momentum_change});
    }
    return all;
}

}  // namespace sph::fpm
