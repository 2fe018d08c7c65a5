#include "common/exact/program/solutions.hpp"

namespace exact::program {

std::vector<std::unique_ptr<Solution>> solutions() {
    std::vector<std::unique_ptr<Solution>> list;
    list.push_back(bar());
    list.push_back(beam());
    list.push_back(bjorken());
    list.push_back(burgers());
    list.push_back(gresho());
    list.push_back(gubser());
    list.push_back(landau());
    list.push_back(noh());
    list.push_back(oblique_shock());
    list.push_back(plate());
    list.push_back(prandtl_meyer());
    list.push_back(rarefaction());
    list.push_back(relativistic_riemann());
    list.push_back(riemann());
    list.push_back(sedov());
    list.push_back(shear_wave());
    list.push_back(taylor_green());
    list.push_back(toy_star());
    list.push_back(transverse());
    list.push_back(two_layer());
    list.push_back(woodward_colella());
    return list;
}

}  // namespace exact::program
