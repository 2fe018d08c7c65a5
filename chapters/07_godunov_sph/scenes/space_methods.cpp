#include "chapters/04_artificial_viscosity/scenes/dissipating.hpp"
#include "chapters/07_godunov_sph/scenes/building.hpp"
#include "common/plot/method_looks.hpp"

namespace sph::godunov {
namespace {

template <int d>
using Wide = ConvolvedGaussian<d, 3>;  // 3 sqrt2 h, where exp(-9) is left of the force

using PaperInPlane = Godunov<PaperConstraint, CubicVolume, ExactRiemann, SoundRate>;
using FirstOrder = Godunov<ConstantSides, CubicVolume, HllcRiemann, ClosingRate>;
using InSpace = Godunov<ThirdOrder, CubicVolume, HllcRiemann, ClosingRate>;
using OfGeometric = Godunov<ThirdOrder, GeometricVolume, HllcRiemann, ClosingRate>;

template <int d>
Method<d> gaussian(const char* name, const char* look, const char* label) {
    return {name, label, plot::look_of(look), "gaussian", 1.0};
}
template <int d>
Method<d> third_order() {
    return with_own_h<Wide<d>>(gaussian<d>("godunov", "godunov", "Godunov SPH"), InSpace{});
}
Method<2> of_geometric() {
    return with_own_h<Wide<2>>(gaussian<2>("geometric-volume", "own-width", "Godunov SPH with (7.16)"),
                               OfGeometric{});
}
Method<2> first_order() {
    const Method<2> method = gaussian<2>("first-order", "limited", "Godunov SPH, first order");
    return with_own_h<Wide<2>>(method, FirstOrder{});
}
/// The recommended one, whose half step knows the line between two particles only.
Method<2> along_the_line() {
    Method<2> method = third_order<2>();
    method.name = "along-line", method.label = "half steps along the line only";
    method.look = plot::look_of("varying-h");
    method.parameters.set("across", 0);
    return method;
}

}  // namespace

const Methods<2>& plane_methods() {
    static const Methods<2> methods{
        "godunov",
        {with_smooth_h<Wide<2>>(gaussian<2>("inutsuka", "inutsuka", "Inutsuka 2002"),
                                as_printed<PaperInPlane>()),
         first_order(), along_the_line(), third_order<2>(), of_geometric()}};
    return methods;
}
const Methods<3>& space_methods() {
    static const Methods<3> methods{"godunov", {third_order<3>()}};
    return methods;
}

Method<3> reconstructed_in_space() {
    using Reconstructed = Dissipation<ReconstructedViscosity, Conduction<ContactSpeed>, FlowSlopes>;
    return shocks::dissipating<3>(
        {"reconstructed", "reconstructed", plot::look_of("reconstructed"), "wendland-c4", 1.6},
        Reconstructed{});
}

}  // namespace sph::godunov
