#pragma once
#include "chapters/05_tensile_instability/scenes/lattice_box.hpp"
#include "common/report/method.hpp"

/// The cures of the tensile instability by name.
namespace sph::tensile {

/// What a cure needs of the scene. Kernel and h of the box are the method's.
struct CureSetup {
    LatticeBox box;
    bool drop = false;  ///< free space around the lattice instead of copies of it

    Box<2> space() const;
};

using CureMethod = report::Method<Integrated<2>, CureSetup>;
using CureMethods = report::Methods<CureMethod>;

/// none, viscosity, background, ... balanced, in the order in which the chapter tells of them.
const CureMethods& cure_methods();

/// The liquid of the setup with that cure, placed and started, with steps by RK4. Throws
/// std::invalid_argument for a kernel that is not known.
std::unique_ptr<Integrated<2>> cured(const CureMethod& method, CureSetup setup);

/// dx/dt of a method: its transport velocity, or v.
const Columns<2>& motion_of(const Integrated<2>& liquid);

}  // namespace sph::tensile
