#include "chapters/06_finite_particle_method/scenes/family.hpp"

namespace sph::fpm {

const std::vector<Member>& members() {
    static const std::vector<Member> all{
        {"sph", "SPH", 0}, {"brookshaw", "SPH, Brookshaw", 0}, {"cspm", "CSPM"}, {"fpm", "FPM"},
        {"sfpm", "SFPM"},  {"taylor", "Taylor SPH"},           {"mls", "MLS"}};
    return all;
}

template std::shared_ptr<const Estimator<1>> estimator<1>(const std::string&, int);

}  // namespace sph::fpm
