#pragma once
#include <memory>
#include <string>
#include <vector>

#include "chapters/06_finite_particle_method/neighbourhood.hpp"

/// The members of the family by name, with any order.
namespace sph::fpm {

/// A member: its name in options and results.csv, what figures call it, and the highest order that it has in
/// d dimensions (an order is that of Taylor's series; 0: it has none, it is a plain sum).
struct Member {
    std::string name, label;
    int usual_order = 2;
};
/// sph, brookshaw (1D), cspm, fpm, sfpm, taylor, mls
const std::vector<Member>& members();

/// The member of that name. d = 1, 2, 3; order 1 or 2, in 1D for sfpm, taylor and mls also 4. Throws
/// std::invalid_argument for what is not there.
template <int d>
std::shared_ptr<const Estimator<d>> estimator(const std::string& name, int order = 2);
extern template std::shared_ptr<const Estimator<1>> estimator<1>(const std::string&, int);
extern template std::shared_ptr<const Estimator<2>> estimator<2>(const std::string&, int);
extern template std::shared_ptr<const Estimator<3>> estimator<3>(const std::string&, int);

}  // namespace sph::fpm
