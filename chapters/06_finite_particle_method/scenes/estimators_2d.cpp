#include "chapters/06_finite_particle_method/scenes/family.hpp"

namespace sph::fpm {

template std::shared_ptr<const Estimator<2>> estimator<2>(const std::string&, int);

}  // namespace sph::fpm
