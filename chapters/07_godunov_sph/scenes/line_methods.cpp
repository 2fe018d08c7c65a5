#include "chapters/07_godunov_sph/scenes/building.hpp"
#include "chapters/07_godunov_sph/scenes/paper_methods.hpp"
#include "common/plot/method_looks.hpp"

namespace sph::godunov {
namespace {

using Narrow = ConvolvedQuadratic<1>;

// [methods]
using Limited = Godunov<VanLeer, CubicVolume, ExactRiemann, ClosingRate>;
using VaryingH = Godunov<VanLeer, GeometricVolume, ExactRiemann, ClosingRate>;
using Recommended = Godunov<ThirdOrder, GeometricVolume, HllcRiemann, ClosingRate>;
// [end]
using WithTwoShocks = Godunov<ThirdOrder, GeometricVolume, TwoShock, ClosingRate>;
using WithExact = Godunov<ThirdOrder, GeometricVolume, ExactRiemann, ClosingRate>;
using Conducting = Godunov<ThirdOrder, GeometricVolume, HllcRiemann, ClosingRate, Conduction<ContactSpeed>>;

template <class Scheme>
Method<1> narrow(const char* name, const char* label, const Scheme& scheme) {
    return with_own_h<Narrow>({name, label, plot::look_of(name), "quadratic", 1.0}, scheme);
}
/// The recommended method with something else: its look with open markers.
template <class Scheme>
Method<1> variant(const char* name, const char* label, const Scheme& scheme) {
    Method<1> method = narrow("godunov", label, scheme);
    method.name = name;
    method.look.filled = false;
    return method;
}
Recommended of_total_energy() {
    Recommended scheme;
    scheme.total_energy = true;
    return scheme;
}
std::vector<Method<1>> all_methods() {
    std::vector<Method<1>> all = gaussian_methods();
    all.push_back(narrow("narrow-faces", "and a narrow kernel", Limited{}));
    all.push_back(narrow("varying-h", "and h that varies", VaryingH{}));
    all.push_back(narrow("godunov", "Godunov SPH", Recommended{}));
    all.push_back(variant("two-shock", "the same, two shocks", WithTwoShocks{}));
    all.push_back(variant("exact-riemann", "the same, exact solver", WithExact{}));
    all.push_back(narrow("conducting", "the same, conducting", Conducting{}));
    all.push_back(variant("total-energy", "the same, total energy", of_total_energy()));
    return all;
}

}  // namespace

const Methods<1>& line_methods() {
    static const Methods<1> methods{"godunov", all_methods()};
    return methods;
}

Method<1> with_calm_start(long steps) {
    Recommended scheme;
    scheme.calm = steps;
    return variant("calm-start", "first steps without slopes", scheme);
}

Method<1> single_precision_energy(bool total) {
    Recommended scheme;
    scheme.single_storage = true, scheme.total_energy = total;
    return variant(total ? "single-e" : "single-u", "Godunov SPH, 24 bits", scheme);
}

}  // namespace sph::godunov
