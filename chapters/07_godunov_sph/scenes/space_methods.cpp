#include "chapters/04_artificial_viscosity/scenes/dissipating.hpp"
#include "chapters/07_godunov_sph/scenes/building.hpp"
#include "common/plot/method_looks.hpp"

namespace sph::godunov {
namespace {

template <int d>
using InSpace = ConvolvedGaussian<d, 3>;  // 3 sqrt2 h, where exp(-9) is left of the force

using PaperInPlane = Godunov<PaperConstraint, CubicVolume, ExactRiemann, SoundRate>;
using FirstOrder = Godunov<ConstantSides, GeometricVolume, HllcRiemann, ClosingRate>;
using ThirdOrderInSpace = Godunov<ThirdOrder, GeometricVolume, HllcRiemann, ClosingRate>;

template <int d>
Method<d> gaussian(const char* name, const char* look, const char* label) {
    return {name, label, plot::look_of(look), "gaussian", 1.0};
}
template <int d>
Method<d> first_order() {
    Method<d> method = gaussian<d>("first-order", "godunov", "Godunov SPH, first order");
    method.look.filled = false;
    return with_own_h<InSpace<d>>(method, FirstOrder{});
}
template <int d>
Method<d> third_order() {
    return with_own_h<InSpace<d>>(gaussian<d>("godunov", "godunov", "Godunov SPH"), ThirdOrderInSpace{});
}

}  // namespace

const Methods<2>& plane_methods() {
    static const Methods<2> methods{
        "godunov",
        {with_smooth_h<InSpace<2>>(gaussian<2>("inutsuka", "inutsuka", "Inutsuka 2002"),
                                   as_printed<PaperInPlane>()),
         first_order<2>(), third_order<2>()}};
    return methods;
}
const Methods<3>& space_methods() {
    static const Methods<3> methods{"godunov", {first_order<3>(), third_order<3>()}};
    return methods;
}

Method<3> reconstructed_in_space() {
    using Reconstructed = Dissipation<ReconstructedViscosity, Conduction<ContactSpeed>, FlowSlopes>;
    return shocks::dissipating<3>(
        {"reconstructed", "reconstructed", plot::look_of("reconstructed"), "wendland-c4", 1.6},
        Reconstructed{});
}

}  // namespace sph::godunov
