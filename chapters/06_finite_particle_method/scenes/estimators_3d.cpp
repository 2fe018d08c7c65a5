#include "chapters/06_finite_particle_method/scenes/family.hpp"

namespace sph::fpm {

template std::shared_ptr<const Estimator<3>> estimator<3>(const std::string&, int);

}  // namespace sph::fpm
