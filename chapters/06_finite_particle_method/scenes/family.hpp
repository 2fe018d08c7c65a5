#pragma once
#include <stdexcept>

#include "chapters/06_finite_particle_method/local_fit.hpp"
#include "chapters/06_finite_particle_method/plain_sums.hpp"
#include "chapters/06_finite_particle_method/scenes/estimators.hpp"

/// The family, made. Included by one file for each dimension: its small matrices take the compiler seconds.
namespace sph::fpm {
namespace estimators_detail {

template <class Basis, int d, int order, Form form>
std::shared_ptr<const Estimator<d>> fit(bool with_volumes) {
    return std::make_shared<LocalFit<Basis, d, order, form>>(with_volumes);
}

template <class Basis, int d, Form form>
std::shared_ptr<const Estimator<d>> of_order(int order, bool with_volumes) {
    if (order == 1) return fit<Basis, d, 1, form>(with_volumes);
    if (order == 2) return fit<Basis, d, 2, form>(with_volumes);
    if constexpr (d == 1 && std::is_same_v<Basis, KernelMoments>) {
        if (order == 4) return fit<Basis, d, 4, form>(with_volumes);
    }
    throw std::invalid_argument{"no fit of order " + std::to_string(order) + " in " + std::to_string(d) +
                                " dimensions"};
}

}  // namespace estimators_detail

template <int d>
std::shared_ptr<const Estimator<d>> estimator(const std::string& name, int order) {
    using estimators_detail::of_order;
    // [family]
    if (name == "sph") return std::make_shared<PlainSums<d>>(Second::twice);
    if (name == "brookshaw" && d == 1) return std::make_shared<PlainSums<d>>(Second::brookshaw);
    if (name == "cspm") return of_order<KernelDerivatives, d, Form::triangular>(order, true);
    if (name == "fpm") return of_order<KernelDerivatives, d, Form::full>(order, true);
    if (name == "sfpm") return of_order<KernelMoments, d, Form::full>(order, true);
    if (name == "taylor") return of_order<KernelMoments, d, Form::keeps_value>(order, true);
    if (name == "mls") return of_order<KernelMoments, d, Form::full>(order, false);
    // [end]
    throw std::invalid_argument{"no such estimate: " + name};
}
}  // namespace sph::fpm
