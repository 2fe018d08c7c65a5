#include "chapters/07_godunov_sph/scenes/paper_methods.hpp"

#include "chapters/07_godunov_sph/scenes/building.hpp"
#include "common/plot/method_looks.hpp"

namespace sph::godunov {
namespace {

using Wide = ConvolvedGaussian<1>;
using WideCut = ConvolvedGaussian<1, 3>;  // 3 sqrt2 h, where exp(-9) is left of the force

// [methods]
using Paper = Godunov<PaperConstraint, CubicVolume, ExactRiemann, SoundRate>;
using PaperFirst = Godunov<ConstantSides, CubicVolume, ExactRiemann, SoundRate>;
using Careful = Godunov<PaperConstraint, CubicVolume, ExactRiemann, ClosingRate>;
using Limited = Godunov<VanLeer, CubicVolume, ExactRiemann, ClosingRate>;
// [end]

Paper of_straight_lines() {
    Paper scheme;
    scheme.volumes.straight = true;
    return scheme;
}
Method<1> described(const char* name, const char* label) {
    return {name, label, plot::look_of(name), "gaussian", 1.0};
}
/// The paper's scheme with something else: its look with open markers.
Method<1> variant(const char* name, const char* label) {
    Method<1> method = described("inutsuka", label);
    method.name = name;
    method.look.filled = false;
    return method;
}

}  // namespace

std::vector<Method<1>> gaussian_methods() {
    return {with_smooth_h<WideCut>(described("inutsuka", "Inutsuka 2002"), as_printed<Paper>()),
            with_smooth_h<WideCut>(variant("inutsuka-linear", "Inutsuka 2002, linear"),
                                   as_printed(of_straight_lines())),
            with_smooth_h<WideCut>(variant("inutsuka-first", "Inutsuka 2002, first order"),
                                   as_printed<PaperFirst>()),
            with_smooth_h<Wide>(described("careful", "with careful steps"), Careful{}),
            with_own_h<Wide>(described("own-width", "and h of its own density"), Careful{}),
            with_own_h<Wide>(described("limited", "and van Leer's limiter"), Limited{})};
}

Method<1> same_h(double h) {
    return solving(variant("inutsuka-same-h", "Inutsuka 2002, one h"), as_printed<Paper>(),
                   [h](const auto&) { return SameWidth<WideCut>{h}; });
}
Method<1> single_precision() {
    Paper scheme = as_printed<Paper>();
    scheme.single_storage = true;
    return with_smooth_h<WideCut>(variant("single", "Inutsuka 2002, 24 bits"), scheme);
}

}  // namespace sph::godunov
